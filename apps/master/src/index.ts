export * from './core/ports/index.ts';
export { DEFAULT_LIMITS } from './core/limits.ts';
export type { LimitName, Limits } from './core/limits.ts';
export type { MasterEndpoints, MasterPorts, MasterSettings } from './core/settings.ts';
export type {
  ConnectionQuery,
  CreateMaster,
  Master,
  MasterMetrics,
  MetricFamily,
  ServiceAnswer,
} from './core/master.ts';
