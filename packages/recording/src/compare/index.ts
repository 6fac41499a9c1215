export { compareOutputs, type CompareOptions, type ComparedSpan } from './compare-outputs.ts';
export {
  compareTopic,
  type OutputDifference,
  type TopicComparison,
  type TopicOptions,
} from './compare-topic.ts';
export type { OutputPair } from './align-outputs.ts';
export { decodedOutput, type Output } from './output-queue.ts';
