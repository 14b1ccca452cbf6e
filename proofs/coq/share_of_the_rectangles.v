cbv beta; lra.
