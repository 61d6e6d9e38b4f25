mod double_pendulum;
