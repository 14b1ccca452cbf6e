intros a b -> ->; eexists; split; [integrated | measured; interval].
