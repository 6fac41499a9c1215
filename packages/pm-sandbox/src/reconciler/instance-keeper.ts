import type { PatternSource } from '@ubii/patterns';
import { ProcessingModuleStatus } from '@ubii/proto';
import type { ModuleFault } from '../ports/module-fault.ts';
import type { ModuleRuntime } from '../runtime/module-runtime.ts';
import { toFault } from '../runtime/to-fault.ts';
import {
  instanceId,
  reconcile,
  type InstanceStep,
  type PresentInstance,
  type WantedInstance,
} from './reconcile.ts';
import { takeStep } from './take-step.ts';

/** Dependencies and callbacks of a keeper. */
export interface InstanceKeeperContext {
  /** Called when the first instance is made, and from then on. */
  readonly runtime: () => ModuleRuntime;
  /** Loaded before an instance whose muxers need it. [TD-64] @default none: the runtime has them at hand */
  readonly patterns?: PatternSource;
  /** The instance is about to be made. */
  readonly onCreate?: (wanted: WantedInstance) => void;
  /** It runs, or is ready if its session is paused. Once for each created instance. */
  readonly onStarted: (wanted: WantedInstance) => void;
  /**
   * It has ended. Also called for a wanted instance that was never created: the session waits for either.
   * @param isWanted it is about to be made again
   */
  readonly onEnded: (wanted: WantedInstance, isWanted: boolean) => void;
  /** It could not be created or changed. Instances that the runtime gives up are reported by the runtime. */
  readonly onFailed: (wanted: WantedInstance, fault: ModuleFault) => void;
  /** It is removed. */
  readonly onGone?: (instanceId: string) => void;
}

/** State of one instance. */
interface Entry {
  readonly id: string;
  sessionId: string;
  wanted: WantedInstance | undefined;
  /** It was wanted as this, and its end was not told since. */
  unreported: WantedInstance | undefined;
  present: PresentInstance | undefined;
  wasStopped: boolean;
  isReported: boolean;
  /** Settles when the steps that are being taken have ended. */
  work: Promise<void> | undefined;
}

/**
 * Keeps the instances of a runtime as their sessions want them: takes the steps of `reconcile`, for each instance one
 * after the other. Every step may take its time, and what is wanted may change meanwhile: the steps that are left are
 * then computed again. All calls of one turn count as one. [PM-62]
 */
export class InstanceKeeper {
  readonly #context: InstanceKeeperContext;
  readonly #entries = new Map<string, Entry>();
  /** To be compared again. */
  readonly #touched = new Set<Entry>();
  #comparing: Promise<void> | undefined;
  #isClosed = false;

  constructor(context: InstanceKeeperContext) {
    this.#context = context;
  }

  /** From now on these are the instances of the session; all others of it end. */
  sync(sessionId: string, wanted: readonly WantedInstance[]): void {
    const ids = new Set(wanted.map(instanceId));
    this.#unwant((entry) => entry.sessionId === sessionId && !ids.has(entry.id));
    for (const one of wanted) {
      const entry = this.#entryOf(instanceId(one), sessionId);
      entry.sessionId = sessionId;
      entry.wanted = one;
      entry.unreported = one;
      this.#touch(entry);
    }
  }

  /** Ends the instances of all other sessions. */
  keepSessions(sessionIds: ReadonlySet<string>): void {
    this.#unwant((entry) => !sessionIds.has(entry.sessionId));
  }

  /** Whether the instance is there, or is being made: not when it failed. */
  has(instanceId: string): boolean {
    const entry = this.#entries.get(instanceId);
    return entry !== undefined && entry.present?.state !== 'failed';
  }

  /** Instances reported as started that are still valid. */
  get started(): readonly WantedInstance[] {
    return [...this.#entries.values()].flatMap(({ isReported, wasStopped, wanted }) =>
      isReported && !wasStopped && wanted !== undefined ? [wanted] : [],
    );
  }

  /**
   * Takes what the runtime says of an instance: one that it gives up has failed. [PM-54]
   *
   * @returns false for an instance that is being made or ends, which tells by itself how that went
   */
  handleStatus(instanceId: string, status: ProcessingModuleStatus, fault?: ModuleFault): boolean {
    const entry = this.#entries.get(instanceId);
    if (entry?.present === undefined || entry.wanted === undefined || entry.wasStopped)
      return false;
    if (status === ProcessingModuleStatus.DESTROYED && fault !== undefined) {
      entry.present = { ...entry.present, state: 'failed' };
      entry.isReported = false;
    }
    return true;
  }

  /** Resolves when there is nothing left to be done. */
  async settled(): Promise<void> {
    for (;;) {
      const work = [...this.#entries.values()].flatMap((entry) => entry.work ?? []);
      if (this.#comparing === undefined && work.length === 0) return;
      await Promise.all([this.#comparing, ...work]);
    }
  }

  /** Takes no further step, and leaves what is there to its runtime. */
  close(): void {
    this.#isClosed = true;
  }

  #entryOf(id: string, sessionId: string): Entry {
    const known = this.#entries.get(id);
    if (known !== undefined) return known;
    const entry: Entry = {
      id,
      sessionId,
      wanted: undefined,
      unreported: undefined,
      present: undefined,
      wasStopped: false,
      isReported: false,
      work: undefined,
    };
    this.#entries.set(id, entry);
    return entry;
  }

  #unwant(isMeant: (entry: Entry) => boolean): void {
    for (const entry of this.#entries.values()) {
      if (!isMeant(entry)) continue;
      entry.wanted = undefined;
      entry.wasStopped = entry.present !== undefined || entry.work !== undefined;
      this.#touch(entry);
    }
  }

  #touch(entry: Entry): void {
    if (this.#isClosed) return;
    this.#touched.add(entry);
    this.#comparing ??= Promise.resolve().then(() => {
      this.#comparing = undefined;
      this.#compare();
    });
  }

  #compare(): void {
    const entries = [...this.#touched].filter(({ work }) => work === undefined);
    for (const entry of entries) this.#touched.delete(entry);
    const steps = reconcile(
      entries.flatMap(({ wanted }) => wanted ?? []),
      entries.flatMap(({ present, wasStopped }) =>
        present === undefined ? [] : [{ ...present, wasStopped }],
      ),
    );
    const plans = new Map<string, InstanceStep[]>();
    for (const step of steps) plans.set(step.id, [...(plans.get(step.id) ?? []), step]);
    for (const [id, plan] of plans) this.#follow(this.#entries.get(id)!, plan);
    for (const entry of entries) {
      // A callback for one instance may change another one at once.
      if (!plans.has(entry.id) && !this.#touched.has(entry)) this.#handleInLine(entry);
    }
  }

  /** The instance is as it is wanted, or failed. */
  #handleInLine(entry: Entry): void {
    const { present, wanted } = entry;
    if (wanted === undefined || present === undefined) {
      this.#entries.delete(entry.id);
      if (entry.unreported !== undefined) this.#context.onEnded(entry.unreported, false);
      this.#context.onGone?.(entry.id);
    } else if (present.state !== 'failed') {
      entry.present = { ...present, as: wanted };
      if (entry.isReported) return;
      entry.isReported = true;
      this.#context.onStarted(wanted);
    }
  }

  #follow(entry: Entry, plan: readonly InstanceStep[]): void {
    entry.work = this.#take(entry, plan).finally(() => {
      entry.work = undefined;
      this.#touch(entry);
    });
  }

  async #take(entry: Entry, plan: readonly InstanceStep[]): Promise<void> {
    for (const step of plan) {
      // The wanted state has changed since the steps were computed.
      if (this.#isClosed || this.#touched.has(entry)) return;
      if (step.kind === 'create') this.#context.onCreate?.(step.wanted);
      const before = entry.present;
      let after: PresentInstance | undefined;
      try {
        const { runtime, patterns } = this.#context;
        after = await takeStep(step, before, runtime(), patterns);
      } catch (reason) {
        if (step.kind !== 'destroy') this.#fail(entry, step.wanted, toFault(reason, ''));
        return;
      }
      if (before !== undefined && step.kind === 'destroy') this.#handleEnd(entry, before);
      // An instance that the runtime gave up in the meantime stays failed.
      else if (entry.present?.state !== 'failed') entry.present = after;
    }
  }

  #fail(entry: Entry, wanted: WantedInstance, fault: ModuleFault): void {
    entry.present = { as: wanted, state: 'failed' };
    entry.isReported = false;
    this.#context.onFailed(wanted, fault);
  }

  #handleEnd(entry: Entry, { as }: PresentInstance): void {
    entry.present = undefined;
    entry.wasStopped = false;
    entry.isReported = false;
    entry.unreported = entry.wanted;
    this.#context.onEnded(as, entry.wanted !== undefined);
  }
}
