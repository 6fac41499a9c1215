import type { Init, MasterStatus } from '@ubii/proto';
import type { Core } from '../areas/core.ts';
import { nameOf } from '../areas/settings.ts';
import { readClusterStatus, type ClusterStatusContext } from './cluster-status.ts';
import { listProblems, type ProblemContext } from './problems.ts';

/** Dependencies of the status. */
export type StatusContext = ProblemContext &
  ClusterStatusContext &
  Pick<Core, 'id' | 'settings' | 'counters' | 'load' | 'topics' | 'samples' | 'events'>;

/**
 * Returns the status of the master. [EX-16]
 * @param sinceMs Samples and events after this moment are wanted; 0 for all that are kept.
 */
export function readMasterStatus(core: StatusContext, sinceMs: number): Init<MasterStatus> {
  const { counters, clients, settings, load } = core;
  const { cpuPercent, busyPercent, delayMs } = load.latest;
  const states = clients.countByStatus();
  const cluster = readClusterStatus(core);
  return {
    masterId: core.id,
    name: nameOf(settings),
    version: settings.version,
    startedMs: core.startedMs,
    nowMs: core.clock.nowMs(),
    recordsIn: counters.recordsIn,
    recordsOut: counters.recordsOut,
    bytesIn: counters.bytesIn,
    bytesOut: counters.bytesOut,
    dropped: counters.dropped,
    refused: counters.refusedTotal + counters.protocolErrors + counters.connectionsRefused,
    topics: core.topics.size,
    clientsActive: states.active,
    clientsInactive: states.inactive,
    clientsUnavailable: states.unavailable,
    cpuPercent,
    busyPercent,
    delayMs,
    processors: load.processors,
    memoryBytes: load.memoryBytes,
    samples: core.samples.since(sinceMs),
    events: core.events.since(sinceMs),
    problems: listProblems(core),
    addresses: settings.endpoints().addresses,
    ...(cluster !== undefined && { cluster }),
  };
}
