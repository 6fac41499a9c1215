import type { SessionStatistics } from '@ubii/proto';
import { quote } from '../../texts/quote.ts';
import { warningProblem } from '../problems.ts';
import type { Session } from '../session.ts';
import type { LockstepContext } from './lockstep-context.ts';
import { PassLoop } from './pass-loop.ts';

/** The lockstep passes of all sessions [SE-40]. */
export class Lockstep {
  readonly #context: LockstepContext;
  readonly #loops = new Map<string, PassLoop>();

  constructor(context: LockstepContext) {
    this.#context = context;
  }

  /** A session came to another state, or has other modules: its passes begin or end. */
  handleLife(session: Session): void {
    const isOn =
      (session.life === 'running' || session.life === 'degraded') &&
      session.modules.some(({ isLockstep }) => isLockstep);
    let loop = this.#loops.get(session.id);
    if (!isOn) {
      loop?.stop();
      if (!session.isLive) this.#loops.delete(session.id);
      return;
    }
    if (loop === undefined) {
      loop = new PassLoop(this.#context, session);
      this.#loops.set(session.id, loop);
    }
    this.#nameStrangers(session);
    loop.start();
  }

  /** A node answers a request [SE-41]. */
  handleReply(
    nodeId: string,
    sessionId: string,
    pass: number,
    outputs: readonly Uint8Array[],
  ): void {
    this.#loops.get(sessionId)?.handleReply(nodeId, pass, outputs);
  }

  /** A node became unavailable, or left. */
  handleNodeGone(nodeId: string): void {
    for (const loop of this.#loops.values()) loop.handleNodeGone(nodeId);
  }

  statistics(
    session: Session,
  ): Pick<SessionStatistics, 'passesPerSecond' | 'passP50Ms' | 'passP95Ms' | 'lateAnswers'> {
    const loop = this.#loops.get(session.id);
    if (loop === undefined) {
      return { passesPerSecond: 0, passP50Ms: 0, passP95Ms: 0, lateAnswers: 0 };
    }
    const { perSecond, p50Ms, p95Ms } = loop.statistics();
    return {
      passesPerSecond: perSecond,
      passP50Ms: p50Ms,
      passP95Ms: p95Ms,
      lateAnswers: loop.lateAnswers,
    };
  }

  close(): void {
    for (const loop of this.#loops.values()) loop.stop();
    this.#loops.clear();
  }

  /** Nodes that know nothing of lockstep requests [SE-42]. */
  #nameStrangers(session: Session): void {
    const { nodes } = this.#context;
    for (const { isLockstep, nodeId } of session.modules) {
      const node = nodes.get(nodeId);
      if (!isLockstep || node === undefined || node.extension !== undefined) continue;
      session.troubles.set(
        `lockstep ${nodeId}`,
        warningProblem({
          code: 'node_without_lockstep',
          message: `The node ${quote(node.label)} does not support lockstep. It runs lockstep modules in a mode of its own.`,
          nodeId,
        }),
      );
    }
  }
}
