import type { SessionStatistics } from '@ubii/proto';
import type { Cancel } from '@ubii/timing';
import { quote } from '../texts/quote.ts';
import type { LifeContext } from './life-context.ts';
import { errorProblem, warningProblem } from './problems.ts';
import type { Session } from './session.ts';
import { evaluate } from './session-life.ts';
import { wireState } from './session-states.ts';

/** Interval of checks and reports of live sessions, milliseconds. [SE-50] */
export const STATISTICS_INTERVAL_MS = 250;
/** The surroundings of a specification are checked again with every fourth look. */
const LOOKS_PER_CHECK = 4;

/** Dependencies of the supervision. */
export interface SupervisionContext extends LifeContext {
  /** Passes of a session since the call before. */
  readonly passes: (
    session: Session,
  ) => Pick<SessionStatistics, 'passesPerSecond' | 'passP50Ms' | 'passP95Ms' | 'lateAnswers'>;
  /** Updates the warnings of a session [SE-5]. */
  readonly recheck: (session: Session) => void;
  /** Updates the problems about topics [SE-61] and failing runs of modules [SE-12]. */
  readonly lookAtTroubles: (session: Session) => void;
}

/** Checks live sessions for late modules, and publishes their statistics. Has a timer only while sessions are live. */
export class Supervision {
  readonly #context: SupervisionContext;
  #cancel: Cancel | undefined = undefined;
  #looks = 0;

  constructor(context: SupervisionContext) {
    this.#context = context;
  }

  /** A session came to another state. */
  handleLife(session: Session): void {
    if (isWatched(session)) {
      this.#cancel ??= this.#context.clock.every(STATISTICS_INTERVAL_MS, () => this.#look());
    } else {
      this.#publish(session);
    }
  }

  close(): void {
    this.#cancel?.();
    this.#cancel = undefined;
  }

  #look(): void {
    const { clock, local, sessions } = this.#context;
    this.#looks++;
    const watched = [...sessions()].filter(isWatched);
    if (watched.length === 0) return this.close();
    const modules = new Map(
      watched.flatMap((session) => session.modules.map((one) => [one.id, one])),
    );
    for (const statistics of local.statistics()) {
      modules.get(statistics.moduleId)?.recordStatistics(statistics, clock.monotonicMs());
    }
    for (const session of watched) {
      this.#lookAt(session);
      this.#publish(session);
    }
  }

  #lookAt(session: Session): void {
    if (session.life === 'stopping') return this.#lookAtStop(session);
    this.#lookAtStart(session);
    if (!session.isLive || this.#looks % LOOKS_PER_CHECK !== 0) return;
    this.#context.recheck(session);
    this.#context.lookAtTroubles(session);
  }

  /** [SE-12] */
  #lookAtStart(session: Session): void {
    const { clock, limits, nodes, news } = this.#context;
    const late = session.modules.filter(
      ({ phase, problem, waitingSinceMs }) =>
        phase === 'waiting' &&
        problem === undefined &&
        clock.monotonicMs() - waitingSinceMs >= limits.startTimeoutMs,
    );
    if (late.length === 0) return;
    for (const module of late) {
      const node = nodes.get(module.nodeId);
      module.handleLate(
        errorProblem({
          code: 'module_not_started',
          message: `The node ${quote(node?.label ?? module.nodeId)} has not reported within ${limits.startTimeoutMs / 1000} s that the module ${quote(module.name)} runs.`,
          moduleId: module.id,
          moduleName: module.name,
          nodeId: module.nodeId,
        }),
      );
    }
    evaluate(this.#context, session);
    news.announceChange(session);
  }

  /** [SE-13] */
  #lookAtStop(session: Session): void {
    const { clock, limits, nodes } = this.#context;
    if (clock.monotonicMs() - session.lifeSinceMs < limits.stopTimeoutMs) return;
    for (const module of session.modules) {
      if (module.phase !== 'ending') continue;
      module.end(false);
      const node = nodes.get(module.nodeId);
      session.troubles.set(
        `stop ${module.nodeId}`,
        warningProblem({
          code: 'module_not_stopped',
          message: `The node ${quote(node?.label ?? module.nodeId)} has not reported within ${limits.stopTimeoutMs / 1000} s that its modules ended. The session stopped without that report.`,
          nodeId: module.nodeId,
        }),
      );
    }
    evaluate(this.#context, session);
  }

  #publish(session: Session): void {
    const { clock, limits, news } = this.#context;
    news.publishStatistics({
      sessionId: session.id,
      state: wireState(session.life),
      timeMs: clock.nowMs(),
      modules: session.modules.flatMap(({ statistics }) => statistics ?? []),
      memoryLimitBytes: limits.moduleBytesPerSession,
      ...this.#context.passes(session),
    });
  }
}

function isWatched(session: Session): boolean {
  return session.isLive || session.life === 'stopping';
}
