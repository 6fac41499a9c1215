export type { Cancel, Clock } from './clock.ts';
export type { IdSource } from './id-source.ts';
export type { ResumeTokens } from './resume-tokens.ts';
export type { Log, LogFields } from './log.ts';
export type { CompiledPattern, PatternCompiler } from './pattern-compiler.ts';
export type { ResourceUsage } from './resource-usage.ts';
export type { BatchEncoder, RecordBatch } from './record-batch.ts';
export type { ClientConnection } from './client-connection.ts';
export type { ConnectionHandle } from './connection-handle.ts';
