export * from './master/built-programs.ts';
export { cpuProfileFlags, type MasterStart } from './master/command-line.ts';
export { MasterProcess, isFailure, type MasterEndpoints } from './master/master-process.ts';
export { readMetrics } from './master/service-call.ts';
export * from './mqtt/start-mosquitto.ts';
export * from './nats/start-nats.ts';
export * from './network/ports.ts';
export * from './network/flaky-network.ts';
export * from './outsider/outsider.ts';
export {
  describeEnd,
  findProgram,
  ServerProcess,
  StartRefused,
  endProgram,
  type ServerCommand,
} from './process/server-process.ts';
export * from './process/process-figures.ts';
