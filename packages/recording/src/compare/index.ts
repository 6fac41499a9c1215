export { compareOutputs, type OutputDifference, type TopicComparison } from './compare-outputs.ts';
export type { CompareOptions, ComparedSpan } from './compare-options.ts';
