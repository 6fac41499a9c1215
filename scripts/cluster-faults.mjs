import { runRobustness } from './lib/robustness.mjs';

await runRobustness('cluster-faults', ['master']);
