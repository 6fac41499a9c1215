import type { EncodedRecord } from '@ubii/pm-sandbox';
import { encodeLockstepRequestFrame, readRecordHead } from '@ubii/proto/wire';
import type { Cancel } from '@ubii/timing';
import { quote } from '../../texts/quote.ts';
import { warningProblem } from '../problems.ts';
import type { Session } from '../session.ts';
import type { SessionModule } from '../session-module.ts';
import { Durations } from './durations.ts';
import type { LockstepContext } from './lockstep-context.ts';
import { SnapshotInputs } from './snapshot-inputs.ts';

/** Passes per second when the session does not say [SE-40]. */
const DEFAULT_HERTZ = 60;

interface Share {
  readonly nodeId: string;
  readonly modules: readonly SessionModule[];
  /** Its outputs; undefined until it has replied. */
  outputs: readonly Uint8Array[] | undefined;
}

interface Pass {
  readonly number: number;
  readonly startedMs: number;
  readonly shares: readonly Share[];
  readonly cancelTimeout: Cancel;
}

/** Runs the lockstep modules of one session, pass after pass. */
export class PassLoop {
  readonly #context: LockstepContext;
  readonly #session: Session;
  readonly #inputs: SnapshotInputs;
  readonly #durations: Durations;
  /** Nodes that have not answered an earlier pass. */
  readonly #late = new Set<string>();
  #number = 0;
  #pass: Pass | undefined = undefined;
  #previousStartMs: number | undefined = undefined;
  #dueMs: number;
  #cancelNext: Cancel | undefined = undefined;
  #isRunning = false;
  lateAnswers = 0;

  constructor(context: LockstepContext, session: Session) {
    this.#context = context;
    this.#session = session;
    this.#inputs = new SnapshotInputs(context, session.id);
    this.#durations = new Durations(context.clock.monotonicMs());
    this.#dueMs = context.clock.monotonicMs();
  }

  start(): void {
    if (this.#isRunning) return;
    this.#isRunning = true;
    this.#previousStartMs = undefined;
    this.#dueMs = this.#context.clock.monotonicMs();
    this.#startNext();
  }

  /** No pass starts any more; what one under way puts out is not published. */
  stop(): void {
    this.#isRunning = false;
    this.#cancelNext?.();
    this.#cancelNext = undefined;
    this.#pass?.cancelTimeout();
    this.#pass = undefined;
    this.#inputs.close();
  }

  /** A node answers [SE-41]. */
  handleReply(nodeId: string, passNumber: number, outputs: readonly Uint8Array[]): void {
    const pass = this.#pass;
    const share = pass?.shares.find((one) => one.nodeId === nodeId);
    if (pass !== undefined && share !== undefined && passNumber === pass.number) {
      share.outputs = outputs;
      this.#endIfComplete();
      return;
    }
    this.lateAnswers++;
    this.#late.delete(nodeId);
    if (this.#session.troubles.delete(`late ${nodeId}`)) {
      this.#context.news.announceChange(this.#session);
    }
  }

  /** A node has left: stops waiting for it and for its results. */
  handleNodeGone(nodeId: string): void {
    this.#late.delete(nodeId);
    this.#session.troubles.delete(`late ${nodeId}`);
    const share = this.#pass?.shares.find((one) => one.nodeId === nodeId);
    if (share === undefined || share.outputs !== undefined) return;
    share.outputs = [];
    this.#endIfComplete();
  }

  /** Passes since the call before. */
  statistics(): ReturnType<Durations['take']> {
    return this.#durations.take(this.#context.clock.monotonicMs());
  }

  #startNext(): void {
    const { clock } = this.#context;
    const delayMs = Math.max(0, this.#dueMs - clock.monotonicMs());
    this.#cancelNext = clock.after(delayMs, () => {
      this.#cancelNext = undefined;
      this.#startPass();
    });
  }

  #startPass(): void {
    const { clock, limits } = this.#context;
    const nowMs = clock.monotonicMs();
    const intervalMs = 1000 / (this.#session.description.lockstepHertz || DEFAULT_HERTZ);
    // Passes that are late are left out, so that the next ones are on time.
    this.#dueMs = Math.max(this.#dueMs + intervalMs, nowMs);
    const shares = this.#shares();
    if (shares.length === 0) {
      this.#previousStartMs = undefined;
      this.#startNext();
      return;
    }
    const deltaTimeMs = nowMs - (this.#previousStartMs ?? nowMs);
    this.#previousStartMs = nowMs;
    const pass: Pass = {
      number: ++this.#number,
      startedMs: nowMs,
      shares,
      cancelTimeout: clock.after(limits.lockstepTimeoutMs, () => this.#giveUp(pass)),
    };
    this.#pass = pass;
    // One snapshot for all nodes, before the first one runs.
    const snapshots = shares.map((share) => this.#snapshot(share));
    shares.forEach((share, index) => {
      this.#ask(pass, share, snapshots[index]!, deltaTimeMs);
    });
  }

  #shares(): Share[] {
    const { nodes, clients } = this.#context;
    const running = this.#session.modules.filter(
      ({ phase, isLockstep }) => phase === 'running' && isLockstep,
    );
    this.#inputs.keep(running);
    const byNode = new Map<string, SessionModule[]>();
    for (const module of running) {
      byNode.set(module.nodeId, [...(byNode.get(module.nodeId) ?? []), module]);
    }
    return [...byNode].flatMap(([nodeId, modules]) => {
      const canRun =
        nodeId === nodes.masterId || clients.get(nodeId)?.node?.runsJavascript === true;
      return canRun && !this.#late.has(nodeId) ? [{ nodeId, modules, outputs: undefined }] : [];
    });
  }

  #snapshot({ nodeId, modules }: Share): EncodedRecord[] {
    const { nodes, local } = this.#context;
    if (nodeId !== nodes.masterId) return this.#inputs.take(modules);
    return local.runtime?.lockstepInputs(modules.map(({ id }) => id)) ?? [];
  }

  #ask(pass: Pass, share: Share, records: EncodedRecord[], deltaTimeMs: number): void {
    const { nodes, clients, local } = this.#context;
    const instanceIds = share.modules.map(({ id }) => id);
    if (share.nodeId === nodes.masterId) {
      const reply = local.runtime?.runPass({ instanceIds, deltaTimeMs, records });
      void Promise.resolve(reply).then(
        (answer) => this.handleReply(share.nodeId, pass.number, answer?.records ?? []),
        () => this.handleReply(share.nodeId, pass.number, []),
      );
      return;
    }
    const head = {
      processingModuleIds: instanceIds,
      deltaTimeMs: Math.round(deltaTimeMs),
      deltaTime: deltaTimeMs,
      pass: pass.number,
      sessionId: this.#session.id,
    };
    const encoded = records.map(({ bytes }) => bytes);
    const client = clients.get(share.nodeId);
    if (client !== undefined) {
      clients.sendFrame(client, encodeLockstepRequestFrame(head, encoded));
    }
  }

  #endIfComplete(): void {
    const pass = this.#pass;
    if (pass === undefined || pass.shares.some(({ outputs }) => outputs === undefined)) return;
    this.#end(pass);
  }

  /** The others do not wait longer [SE-41]. */
  #giveUp(pass: Pass): void {
    if (this.#pass !== pass) return;
    const { nodes, news, limits } = this.#context;
    for (const { nodeId, outputs } of pass.shares) {
      if (outputs !== undefined) continue;
      this.#late.add(nodeId);
      const name = quote(nodes.get(nodeId)?.label ?? nodeId);
      this.#session.troubles.set(
        `late ${nodeId}`,
        warningProblem({
          code: 'node_late',
          message: `The node ${name} has not answered a lockstep pass within ${limits.lockstepTimeoutMs} ms. It is left out until it answers.`,
          nodeId,
        }),
      );
    }
    news.announceChange(this.#session);
    this.#end(pass);
  }

  /** All outputs are published together, in the order of the modules [SE-41]. */
  #end(pass: Pass): void {
    const { clock, clients, publish } = this.#context;
    pass.cancelTimeout();
    this.#pass = undefined;
    const places = outputPlaces(this.#session);
    const outputs = pass.shares.flatMap(({ nodeId, modules, outputs: records }) => {
      let place = this.#session.modules.indexOf(modules[0]!);
      return (records ?? []).map((record) => {
        // Topics of demuxers are not known beforehand: they follow what comes before them.
        place = places.get(`${nodeId} ${readRecordHead(record).topic}`) ?? place;
        return { record, place, publisher: clients.get(nodeId) };
      });
    });
    outputs.sort((a, b) => a.place - b.place);
    for (const { record, publisher } of outputs) {
      publish(record, publisher, this.#session.id);
    }
    this.#durations.add(clock.monotonicMs() - pass.startedMs);
    if (this.#isRunning) this.#startNext();
  }
}

/** Place of the module that writes a topic, by node and topic. */
function outputPlaces({ modules }: Session): Map<string, number> {
  const places = new Map<string, number>();
  modules.forEach(({ nodeId, mapping }, place) => {
    for (const { topic } of mapping.outputMappings) {
      if (topic) places.set(`${nodeId} ${topic}`, place);
    }
  });
  return places;
}
