import { runRobustness } from './lib/robustness.mjs';

await runRobustness('soak', ['master']);
