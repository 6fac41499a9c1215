import type { ModuleStatistics } from '@ubii/proto';
import { Streak } from '../counters/streak.ts';
import { quote } from '../texts/quote.ts';
import { warningProblem } from './problems.ts';
import type { Session } from './session.ts';
import type { SessionModule } from './session-module.ts';

/** State of a module at the last check. */
interface Look {
  /** Elements refused until then, since the module was created. */
  refused: number;
  /** Monotonic milliseconds. */
  atMs: number;
  readonly streak: Streak;
}

/** Dependencies of the reports on such troubles. */
export interface TopicTroublesContext {
  readonly monotonicMs: () => number;
  /** A row of refused elements begins. @param text a sentence without its end */
  readonly onRunaway: (session: Session, module: SessionModule, text: string) => void;
  /** The problems of the session changed. */
  readonly onChange: (session: Session) => void;
}

/** Problems of modules whose demuxers exceed their number of topics. [SE-61] */
export class TopicTroubles {
  readonly #context: TopicTroublesContext;
  readonly #looks = new WeakMap<SessionModule, Look>();

  constructor(context: TopicTroublesContext) {
    this.#context = context;
  }

  look(session: Session): void {
    let hasChanged = false;
    for (const module of session.modules) {
      if (this.#lookAt(session, module)) hasChanged = true;
    }
    const keys = new Set(session.modules.map(keyOf));
    for (const key of session.troubles.keys()) {
      if (!key.startsWith(PREFIX) || keys.has(key)) continue;
      session.troubles.delete(key);
      hasChanged = true;
    }
    if (hasChanged) this.#context.onChange(session);
  }

  /** @returns whether the problems changed */
  #lookAt(session: Session, module: SessionModule): boolean {
    const { statistics } = module;
    if (statistics === undefined) return false;
    const nowMs = this.#context.monotonicMs();
    const { topicsRefused: refused } = statistics;
    const look = this.#looks.get(module);
    if (look === undefined) {
      // Earlier refusals, perhaps long ago, have no rate.
      this.#looks.set(module, { refused, atMs: nowMs, streak: new Streak() });
      return false;
    }
    // A module that was created again counts from the beginning.
    const more = refused < look.refused ? refused : refused - look.refused;
    const perSecond = (more * 1000) / Math.max(1, nowMs - look.atMs);
    look.refused = refused;
    look.atMs = nowMs;
    if (more === 0) return !look.streak.isOn(nowMs) && session.troubles.delete(keyOf(module));
    const isNew = look.streak.add(nowMs);
    if (!isNew && session.troubles.has(keyOf(module))) return false;
    const text = describe(session, module, statistics, perSecond);
    session.troubles.set(
      keyOf(module),
      warningProblem({
        code: 'too_many_topics',
        message: `${text}. Existing topics continue. Use parameters that repeat, such as identities.`,
        moduleId: module.id,
        moduleName: module.name,
        nodeId: module.nodeId,
      }),
    );
    this.#context.onRunaway(session, module, text);
    return true;
  }
}

const PREFIX = 'topics ';

function keyOf({ id }: SessionModule): string {
  return `${PREFIX}${id}`;
}

function describe(
  session: Session,
  module: SessionModule,
  { topics, refusedOutput }: ModuleStatistics,
  perSecond: number,
): string {
  // Bound the text, which comes from a node and is shown to users.
  const output = quote(refusedOutput.slice(0, 64));
  return `The demuxer of the output ${output} of the module ${quote(module.name)} in the session ${quote(session.label)} makes too many topics: it has ${topics}, and ${Math.round(perSecond)} more a second are refused`;
}
