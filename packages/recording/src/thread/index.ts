export type { CheckLimits } from './check-messages.ts';
export { ProcessChecker, type ProcessCheckerOptions } from './process-checker.ts';
export { recordOnThread, type ThreadRecorderOptions } from './thread-recorder.ts';
