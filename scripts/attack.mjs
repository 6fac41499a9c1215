import { runRobustness } from './lib/robustness.mjs';

await runRobustness('attack', ['master']);
