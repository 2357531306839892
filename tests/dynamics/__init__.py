"""Mass matrices, their factors, multipliers, and the kernels in C behind them."""
