import { StatusProblemSeverity } from '@ubii/proto';
import type { Client } from '../clients/client.ts';
import type { UsageMeasurement } from '../ports/resource-usage.ts';
import { quote } from '../texts/quote.ts';
import { type FoundProblem, Findings } from './findings.ts';
import { type ModuleLoad, checkModules, loadsOf } from './check-modules.ts';
import { throttleClient, unthrottleClient, type ThrottlingContext } from '../clients/throttling.ts';
import type { NodeTable } from '../nodes/node-table.ts';
import type { Session } from '../sessions/session.ts';
import type { Load } from '../counters/load.ts';
import type { Problem } from './problem.ts';
import type { CheckSettings } from './check-settings.ts';

/** From here on users notice that the master is busy, percent [EX-46]. */
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
function* checkMachine(state: MachineState): Iterable<[key: string, FoundProblem]> {
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

/**
 * Share of the master's thread that the records of a client take, percent [EX-47].
 * @param workPercent of the time in which the thread really computes
 */
function threadPercentOf(client: Client, workPercent: number): number {
  return client.traffic.workShare * workPercent;
}

/** The key of what is found about a publisher. */
function noisyKey(clientId: string): string {
  return `publisher_noisy ${clientId}`;
}

/** Clients that use more of the master than their share. [EX-47] */
function* checkPublishers(
  clients: Iterable<Client>,
  workPercent: number,
  publisherPercent: number,
): Iterable<[key: string, FoundProblem]> {
  for (const client of clients) {
    const { recordsInPerSecond, throttledPerSecond } = client.traffic.rates;
    const percent = threadPercentOf(client, workPercent);
    // A client that only subscribes is not a publisher, whatever its cost.
    if (percent <= publisherPercent || recordsInPerSecond + throttledPerSecond === 0) continue;
    yield [
      noisyKey(client.id),
      {
        code: 'publisher_noisy',
        severity: StatusProblemSeverity.WARNING,
        text: `${client.label} publishes ${Math.round(recordsInPerSecond)} records per second, which take ${Math.round(percent)} % of the time of the master. All other clients share the rest.`,
        clientId: client.id,
        remedy: 'Publish less often or smaller records, or throttle the client.',
      },
    ];
  }
}

/** The smallest rate the policy throttles to, records per second [EX-48]. */
const MIN_RECORDS_PER_SECOND = 10;
/** Looks in a row in which all of a throttled client has fitted before it is let go [EX-48]. */
const LOOKS_TO_LIFT = 10;

/** Time after its start in which a master is not judged, milliseconds: it loads, and its clients come back [EX-45]. */
export const START_MS = 10_000;

/** Dependencies of the checks. */
interface OverloadContext extends ThrottlingContext {
  readonly settings: CheckSettings;
  readonly clients: { values(): Iterable<Client>; get(id: string): Client | undefined };
  readonly nodes: NodeTable;
  readonly sessions: () => readonly Session[];
}

/** Compares what clients and modules ask for with what the machine can do [EX-45]. */
export class OverloadChecks {
  readonly #context: OverloadContext;
  readonly #findings: Findings;
  readonly #judgedFromMs: number;
  /** Overruns of each module at the last look. */
  #overruns: ReadonlyMap<string, number> = new Map();
  /** Of each client the policy throttled: looks in a row in which it has fitted. */
  readonly #fitting = new Map<string, number>();

  constructor(context: OverloadContext) {
    this.#context = context;
    this.#findings = new Findings(context.clock, context.events);
    this.#judgedFromMs = context.clock.monotonicMs() + START_MS;
  }

  problems(): Problem[] {
    return this.#findings.problems();
  }

  /** To be called after each measurement of load and clients. */
  look({ latest: usage, processors }: Load): void {
    const { settings, clients, nodes, sessions, clock } = this.#context;
    if (settings.checks === 'off' || clock.monotonicMs() < this.#judgedFromMs) return;
    // A master that waits for a processor used by other programs is busy, but no client causes the load.
    const workPercent = Math.min(usage.busyPercent, usage.cpuPercent);
    const modules = loadsOf(sessions());
    const found = new Map<string, FoundProblem>([
      ...checkMachine({
        usage,
        processors,
        busyPercent: settings.busyPercent,
        clients: clients.values(),
        modules: modules.filter(({ nodeId }) => nodeId === nodes.masterId),
      }),
      ...checkPublishers(clients.values(), workPercent, settings.publisherPercent),
      ...checkModules(modules, this.#overruns, (id) => nodes.get(id)?.label ?? id, nodes.masterId),
    ]);
    this.#overruns = new Map(
      modules.map(({ moduleId, statistics }) => [moduleId, statistics.overruns]),
    );
    this.#findings.take(found);
    if (settings.checks === 'throttle') this.#applyPolicy(workPercent);
  }

  /** [EX-48] */
  #applyPolicy(workPercent: number): void {
    const isBusy = this.#findings.isNow('master_busy');
    for (const client of this.#context.clients.values()) {
      if (client.throttle?.byPolicy === true) this.#look(client, workPercent);
      else if (client.throttle === undefined && isBusy && this.#findings.isNow(noisyKey(client.id)))
        this.#throttle(client, workPercent);
    }
    for (const id of this.#fitting.keys()) {
      if (this.#context.clients.get(id)?.throttle?.byPolicy !== true) this.#fitting.delete(id);
    }
  }

  #throttle(client: Client, workPercent: number): void {
    const { publisherPercent } = this.#context.settings;
    const { recordsInPerSecond } = client.traffic.rates;
    const fits = publisherPercent / threadPercentOf(client, workPercent);
    throttleClient(this.#context, client, {
      recordsPerSecond: Math.max(MIN_RECORDS_PER_SECOND, Math.floor(recordsInPerSecond * fits)),
      byPolicy: true,
      byName: '',
      reason: `its records took more than ${publisherPercent} % of the time of the master`,
    });
    this.#fitting.set(client.id, 0);
  }

  /** Lets a throttled client go when what it wants to publish fits. */
  #look(client: Client, workPercent: number): void {
    const { recordsInPerSecond, throttledPerSecond } = client.traffic.rates;
    const wanted = recordsInPerSecond + throttledPerSecond;
    const percent = threadPercentOf(client, workPercent);
    const wantedPercent = recordsInPerSecond === 0 ? 0 : (percent * wanted) / recordsInPerSecond;
    const fits =
      wanted <= client.throttle!.recordsPerSecond &&
      wantedPercent <= this.#context.settings.publisherPercent;
    const looks = fits ? (this.#fitting.get(client.id) ?? 0) + 1 : 0;
    this.#fitting.set(client.id, looks);
    if (looks >= LOOKS_TO_LIFT) unthrottleClient(this.#context, client, '');
  }
}
