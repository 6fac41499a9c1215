import { runRobustness } from './lib/robustness.mjs';

await runRobustness('fuzz', ['master']);
