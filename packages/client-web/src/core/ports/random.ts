/** Source of the jitter in reconnect delays: uniform in [0, 1). */
export type RandomSource = () => number;
