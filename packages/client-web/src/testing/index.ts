export { createTestClient } from './create-test-client.ts';
export type { TestClient } from './create-test-client.ts';
export { FakeMaster } from './fake-master.ts';
export { FakeSessions } from './fake-sessions.ts';
export { describeIdentityStorage } from './identity-storage-suite.ts';
export type { IdentityStorageWorld } from './identity-storage-suite.ts';
export { describeServiceTransport } from './service-transport-suite.ts';
export type { AnswerRequest, ServiceTransportWorld } from './service-transport-suite.ts';
export { describeTopicDataTransport } from './topic-data-transport-suite.ts';
export type {
  ServerEvents,
  ServerSocket,
  TopicDataTransportWorld,
} from './topic-data-transport-suite.ts';
export { createMemoryServices, createMemoryTopicData } from '../transports/memory.ts';
export type { MemoryConnection, MemoryMaster, MemoryPeer } from '../transports/memory.ts';
