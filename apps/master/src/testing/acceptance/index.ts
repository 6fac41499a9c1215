export { accessSecretsSuite } from './access-secrets-suite.ts';
export { clientConnectionSuite } from './client-connection-suite.ts';
export type { ClientEnd, ConnectionBench, OpenBench, Seen } from './connection-bench.ts';
export { Inbox } from './inbox.ts';
export { pingText, readClose, readText, readTopicData } from './read-seen.ts';
export { auditStoreSuite } from './audit-store-suite.ts';
export { idSourceSuite } from './id-source-suite.ts';
export { logSuite, type WrittenLine } from './log-suite.ts';
export {
  addAll,
  recorderSuite,
  recordsToKeep,
  runningJob,
  type RecorderParts,
} from './recorder-suite.ts';
export { clusterBusSuite, type BusBench } from './cluster-bus-suite.ts';
export { ownerStoreSuite, type OwnerBench } from './owner-store-suite.ts';
export { resourceUsageSuite } from './resource-usage-suite.ts';
export { resumeTokensSuite } from './resume-tokens-suite.ts';
export { documentStoreSuite, type StoreParts } from './document-store-suite.ts';
