import { runRobustness } from './lib/robustness.mjs';

await runRobustness('faults', ['master', 'node']);
