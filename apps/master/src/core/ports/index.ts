export type { AccessSecrets } from './access-secrets.ts';
export type { AddressKind } from './address-kind.ts';
export { LOCAL_CALLER, TRUSTED_CALLER } from './caller-facts.ts';
export type { CallerFacts, CallerStanding } from './caller-facts.ts';
export type { AssetSets } from './asset-sets.ts';
export type { AuditStore } from './audit-store.ts';
export type { IdSource } from './id-source.ts';
export type { ResumeTokens } from './resume-tokens.ts';
export type { Lan } from './lan.ts';
export type { Log, LogFields } from './log.ts';
export type { CompiledPattern, PatternCompiler } from '@ubii/patterns';
export { FLIGHT_TARGET } from '@ubii/recording/recorder';
export type {
  FlightJob,
  KeptRecording,
  MarkerJob,
  Recorder,
  RecorderList,
  RecorderState,
  RecordingJob,
  RecordingTexts,
  RunningJob,
} from '@ubii/recording/recorder';
export type {
  PlayedBatch,
  PlayedPart,
  PlayerCommand,
  PlayerSink,
  PlayerState,
  ReplayFacts,
  ReplayFile,
  ReplayFiles,
  ReplayPlayer,
} from './replay-files.ts';
export type { ResourceUsage, UsageMeasurement } from './resource-usage.ts';
export type { BatchEncoder, RecordBatch } from './record-batch.ts';
export type { ClientConnection } from './client-connection.ts';
export { CLOSE_REASONS } from './close-reason.ts';
export type { ClientEnding, CloseReason } from './close-reason.ts';
export type { ClientClaim, ConnectionPeer } from './connection-facts.ts';
export type { ConnectionHost } from './connection-host.ts';
export type {
  DocumentStore,
  SessionStorage,
  StoredDocument,
  StudyStorage,
} from './document-store.ts';
export type { ConnectionHandle } from './connection-handle.ts';
export type { BusListener, ClusterBus } from './cluster-bus.ts';
export type { MessageSeal } from './message-seal.ts';
export type { OwnerStore } from './owner-store.ts';
