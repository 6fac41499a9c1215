import { StatusProblemSeverity } from '@ubii/proto';
import type { Client } from '../clients/client.ts';
import type { UsageMeasurement } from '../ports/resource-usage.ts';
import { quote } from '../texts/quote.ts';
import type { FoundProblem } from './findings.ts';
import type { ModuleLoad } from './check-modules.ts';

/** From here on everybody notices that the master is busy, percent [EX-46]. */
const FULL_PERCENT = 95;
/** Share of the work from which one client is named as the cause [EX-46]. */
const CAUSE_SHARE = 1 / 3;

/** Dependencies of the check of the machine. */
export interface MachineState {
  readonly usage: UsageMeasurement;
  readonly processors: number;
  readonly busyPercent: number;
  readonly clients: Iterable<Client>;
  /** Modules that run on the master. */
  readonly modules: readonly ModuleLoad[];
}

/** Whether the master, or all of its machine, has too much to do [EX-46]. */
export function* checkMachine(state: MachineState): Iterable<[key: string, FoundProblem]> {
  const { usage, processors, busyPercent } = state;
  if (usage.busyPercent > busyPercent) yield ['master_busy', masterBusy(state)];
  if (usage.cpuPercent > busyPercent * processors) yield ['machine_busy', machineBusy(state)];
}

function masterBusy({ usage, clients }: MachineState): FoundProblem {
  // The master waits for a processor most of the time: clients and modules are not the cause.
  const isStarved = usage.cpuPercent < usage.busyPercent / 2;
  const first = isStarved ? undefined : busiest(clients);
  const cause = isStarved
    ? 'it waits most of that time, because other programs use the processor'
    : first === undefined
      ? 'no single client causes it'
      : `${percent(first.traffic.workShare * 100)} of the forwarding work is caused by ${first.label}`;
  return {
    code: 'master_busy',
    severity:
      usage.busyPercent >= FULL_PERCENT
        ? StatusProblemSeverity.ERROR
        : StatusProblemSeverity.WARNING,
    text: `The main thread of the master is busy for ${percent(usage.busyPercent)} of the time. Its event-loop delay is ${Math.round(usage.delayMs)} ms, so values arrive later; ${cause}.`,
    clientId: first?.id ?? '',
    remedy: isStarved
      ? 'End other programs on the machine of the master, or run the master on another machine.'
      : first === undefined
        ? 'Publish less often, subscribe to less or at a lower rate, or run the master on a faster machine.'
        : 'Publish or subscribe at a lower rate in that client, or throttle it.',
  };
}

function machineBusy({ usage, processors, modules }: MachineState): FoundProblem {
  const [first] = [...modules].sort((a, b) => b.coreShare - a.coreShare);
  const cause =
    first === undefined
      ? 'no module runs on it'
      : `the module ${quote(first.name)} of the session ${quote(first.sessionLabel)} takes most, ${percent(first.coreShare * 100)} of a core`;
  return {
    code: 'machine_busy',
    severity: StatusProblemSeverity.WARNING,
    text: `The master and its modules take ${percent(usage.cpuPercent / processors)} of the ${processors} cores of their machine; ${cause}.`,
    remedy: 'Lower the frequency of modules, stop sessions, or run some of them on another node.',
    sessionId: first?.sessionId ?? '',
    moduleId: first?.moduleId ?? '',
  };
}

function busiest(clients: Iterable<Client>): Client | undefined {
  let most: Client | undefined;
  for (const client of clients) {
    if (most === undefined || client.traffic.workShare > most.traffic.workShare) most = client;
  }
  return most !== undefined && most.traffic.workShare >= CAUSE_SHARE ? most : undefined;
}

function percent(value: number): string {
  return `${Math.round(value)} %`;
}
