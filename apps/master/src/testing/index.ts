export { FakeClock } from './fake-clock.ts';
export { FixedUsage } from './fixed-usage.ts';
export { NativePatterns } from './native-patterns.ts';
export { PlainTokens } from './plain-tokens.ts';
export { RecordingConnection, type Sent } from './recording-connection.ts';
export { RecordingLog, type LogLine } from './recording-log.ts';
export { SequentialIds } from './sequential-ids.ts';
export { emptyRecord, frameOf, TestClient } from './test-client.ts';
export { TestMaster, type TestMasterOptions } from './test-master.ts';
