"""What is written of the ledger and of the racket: words, pages, figures and charts."""
