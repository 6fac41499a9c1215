export * from './core/ports/index.ts';
export { createMaster } from './core/master/create-master.ts';
export { fitConnections } from './core/connections/fit-connections.ts';
export { DEFAULT_LIMITS } from './core/limits/index.ts';
export { LogTail } from './core/counters/log-tail.ts';
export type { LimitName, Limits } from './core/limits/index.ts';
export type { MasterEndpoints, MasterPorts, MasterSettings } from './core/areas/settings.ts';
export type {
  Master,
  MasterMetrics,
  MetricFamily,
  ServiceAnswer,
  TerminalAccess,
  TerminalJoin,
} from './core/master/master.ts';
