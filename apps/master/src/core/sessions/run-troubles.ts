import { ModuleEventKind, type ModuleEvent } from '@ubii/proto';
import { quote } from '../texts/quote.ts';
import { errorProblem } from './problems.ts';
import type { Session } from './session.ts';
import type { SessionModule } from './session-module.ts';

/** After an event, statistics may be from before it, milliseconds: longer than between two looks. */
const SETTLE_MS = 2500;
/** Runs without an error for so long count as repaired, milliseconds: other inputs may still fail. */
const MENDED_MS = 5000;
/** The same for nodes that report no statistics. */
const SILENT_MS = 30_000;
/** State of a module whose runs fail. */
interface Failing {
  /** Since the instance was created, when it failed last. */
  runs: number;
  /** Monotonic milliseconds. */
  failedMs: number;
}

/** Dependencies of the reports on such troubles. */
export interface RunTroublesContext {
  readonly monotonicMs: () => number;
  /** The problems of the session changed. */
  readonly onChange: (session: Session) => void;
}

/** Problems of modules whose runs fail. [SE-12] */
export class RunTroubles {
  readonly #context: RunTroublesContext;
  readonly #failing = new WeakMap<SessionModule, Failing>();

  constructor(context: RunTroublesContext) {
    this.#context = context;
  }

  /** Handles an event of a module. The first cause stays until its runs succeed. */
  handleEvent(session: Session, module: SessionModule, event: ModuleEvent): void {
    if (!session.isLive || !isFailure(event)) return;
    const { message, line, column } = event;
    const failedMs = this.#context.monotonicMs();
    this.#failing.set(module, { runs: runsOf(module), failedMs });
    if (session.troubles.has(keyOf(module))) return;
    session.troubles.set(
      keyOf(module),
      errorProblem({
        code: 'module_run_failed',
        message: `A run of the module ${quote(module.name)} failed: ${message}`.replace(
          /\.?$/,
          '.',
        ),
        moduleId: module.id,
        moduleName: module.name,
        nodeId: module.nodeId,
        line,
        column,
      }),
    );
    this.#context.onChange(session);
  }

  /** Drops what is repaired. */
  look(session: Session): void {
    const standing = new Map(session.modules.map((module) => [keyOf(module), module]));
    let hasChanged = false;
    for (const key of session.troubles.keys()) {
      if (!key.startsWith(PREFIX)) continue;
      const module = standing.get(key);
      if (module !== undefined && !this.#isMended(module)) continue;
      if (module !== undefined) this.#failing.delete(module);
      session.troubles.delete(key);
      hasChanged = true;
    }
    if (hasChanged) this.#context.onChange(session);
  }

  #isMended(module: SessionModule): boolean {
    const failing = this.#failing.get(module);
    // Updated: a failure is reported again.
    if (failing === undefined) return true;
    const sinceMs = this.#context.monotonicMs() - failing.failedMs;
    const runs = runsOf(module);
    // An instance that was created again counts from the beginning.
    const isNew = runs < failing.runs;
    if (sinceMs < SETTLE_MS) {
      if (!isNew) failing.runs = runs;
      return false;
    }
    if (module.statistics === undefined) return sinceMs >= SILENT_MS;
    return isNew || (runs > failing.runs && sinceMs >= MENDED_MS);
  }
}

const PREFIX = 'run ';

const keyOf = ({ id }: SessionModule): string => `${PREFIX}${id}`;

const runsOf = ({ statistics }: SessionModule): number => statistics?.runs ?? 0;

/**
 * A run failed, or what it put out was refused. Nodes repeat both once a second at most. [PM-81]
 * Events without a callback are no faults of a run: mismatched topics, or too many topics. [SE-61]
 */
const isFailure = ({ kind, phase }: ModuleEvent): boolean =>
  phase !== '' && (kind === ModuleEventKind.ERROR || kind === ModuleEventKind.REFUSED);
