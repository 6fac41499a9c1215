import type { Client } from '../clients/client.ts';
import { throttleClient, unthrottleClient, type ThrottlingContext } from '../clients/throttling.ts';
import type { NodeTable } from '../nodes/node-table.ts';
import type { Session } from '../sessions/session.ts';
import type { Load } from '../counters/load.ts';
import type { Problem } from './problem.ts';
import { checkMachine } from './check-machine.ts';
import { checkModules, loadsOf } from './check-modules.ts';
import { checkPublishers, noisyKey, threadPercentOf } from './check-publishers.ts';
import type { CheckSettings } from './check-settings.ts';
import { Findings, type FoundProblem } from './findings.ts';

/** The smallest rate the policy throttles to, records per second [EX-48]. */
const MIN_RECORDS_PER_SECOND = 10;
/** Looks in a row in which all of a throttled client has fitted before it is let go [EX-48]. */
const LOOKS_TO_LIFT = 10;

/** Time after its start in which a master is not judged, milliseconds: it loads, and its clients come back [EX-45]. */
export const START_MS = 10_000;

/** Dependencies of the checks. */
export interface OverloadContext extends ThrottlingContext {
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
