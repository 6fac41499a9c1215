import type { PatternCompiler } from '@ubii/patterns';
import { createModuleRuntime, type SandboxFactory } from '@ubii/pm-sandbox';
import { decodeRecord, ModuleEventKind, type ProcessingModule } from '@ubii/proto';
import { devicesByTopic, topicsOfProfile } from '@ubii/recording';
import { decodedOutput, type TopicComparison } from '@ubii/recording/compare';
import { TryTopics } from './try-topics.ts';
import { caseTimeNs, compareCaseOutputs, isSame, type CaseOutput } from './compare-outputs.ts';
import { encodeCaseRecord, type CaseRecord, type ModuleCase } from './module-case.ts';
import { SteppedClock } from './stepped-clock.ts';

/** What a case came to. */
export interface CaseResult {
  readonly isPassed: boolean;
  readonly topics: readonly TopicComparison[];
  /** The first error of the module. */
  readonly fault: string | undefined;
}

const CASE_ID = 'case';
/** Interval of lockstep passes, the default of sessions, milliseconds. [SE-40] */
const PASS_MS = 1000 / 60;
const MIN_WINDOW_MS = 100;
/** A chain of promises of the runtime is no longer than this. */
const SETTLE_TURNS = 20;

/** Waits until no run of a module is under way. */
class Runs {
  readonly #pending = new Set<Promise<unknown>>();

  readonly rest = async (): Promise<void> => {
    for (;;) {
      for (let turn = 0; turn < SETTLE_TURNS; turn++) await Promise.resolve();
      if (this.#pending.size === 0) return;
      await Promise.allSettled(this.#pending);
    }
  };

  /** Wraps sandboxes, so that their runs are waited for. */
  of(sandboxes: SandboxFactory): SandboxFactory {
    return {
      open: (request, events) => {
        const sandbox = sandboxes.open(request, events);
        return {
          create: () => sandbox.create(),
          halt: () => sandbox.halt(),
          destroy: () => sandbox.destroy(),
          terminate: () => sandbox.terminate(),
          run: (call) => this.track(sandbox.run(call)),
        };
      },
      check: (source) => sandboxes.check(source),
      // The owner of the wrapped sandboxes closes them.
      close: () => Promise.resolve(),
    };
  }

  track<T>(run: Promise<T>): Promise<T> {
    const done = run.finally(() => this.#pending.delete(run));
    this.#pending.add(run);
    return done;
  }
}

/**
 * Feeds the inputs of a case to a module in recorded time, and compares what it puts out.
 *
 * @param module with the code to test; inputs and outputs are connected by name, as recorded
 * @throws Error with a sentence when it cannot be run
 */
export async function runCase(
  theCase: ModuleCase,
  module: ProcessingModule,
  sandboxes: SandboxFactory,
  patterns: PatternCompiler,
): Promise<CaseResult> {
  if (module.processingMode?.free)
    throw new Error('A module that runs freely has no rhythm that a test could repeat.');
  const clock = new SteppedClock(theCase.startMs);
  const runs = new Runs();
  const outputs: CaseOutput[] = [];
  let fault: string | undefined;
  const take = (topic: string, bytes: Uint8Array): void => {
    const record = decodedOutput(bytes);
    if (record !== undefined)
      outputs.push({ topic, timeNs: caseTimeNs(clock.monotonicMs()), record });
  };
  /** Passes do not publish; their records are complete. */
  const takePassed = (bytes: Uint8Array): void => take(decodeRecord(bytes).topic, bytes);
  const deviceIds = devicesByTopic(theCase.devices);
  const topics = new TryTopics(patterns, {
    onOutput: take,
    topicsOf: (profile) => topicsOfProfile(profile, theCase.devices),
    deviceOf: (topic) => deviceIds.get(topic),
  });
  const runtime = createModuleRuntime({
    nodeId: 'this-page',
    clock,
    topics,
    patterns,
    sandboxes: runs.of(sandboxes),
    libraries: [],
    limits: { maxRestarts: 0 },
    onEvent({ kind, message }) {
      if (kind === ModuleEventKind.ERROR || kind === ModuleEventKind.KILLED) fault ??= message;
    },
    onStatus: (_id, _status, found) => void (fault ??= found?.message),
  });
  try {
    const extension = module.extension && { ...module.extension, libraries: [] };
    await runtime.create({
      module: { ...module, id: CASE_ID, sessionId: CASE_ID, extension },
      mapping: { ...theCase.mapping, processingModuleId: CASE_ID },
      isTrusted: false,
    });
    runtime.start(CASE_ID);
    const put = (record: CaseRecord): void =>
      topics.put(record.topic, encodeCaseRecord(record), record.publisherId);
    theCase.before.forEach(put);
    await runs.rest();
    // These belong to the time before
    outputs.length = 0;
    if (module.processingMode?.lockstep)
      clock.every(PASS_MS, () => {
        const records = runtime.lockstepInputs([CASE_ID]);
        const pass = runtime.runPass({ instanceIds: [CASE_ID], deltaTimeMs: PASS_MS, records });
        void runs.track(pass.then((reply) => reply.records.forEach(takePassed)));
      });
    for (const input of theCase.inputs) {
      await clock.moveTo(input.atMs, runs.rest);
      put(input);
      await runs.rest();
    }
    await clock.moveTo(theCase.durationMs, runs.rest);
  } catch (error) {
    fault ??= (error as { readonly message?: string }).message ?? String(error);
  } finally {
    await runtime.close();
  }
  const { tolerance, durationMs } = theCase;
  const exactness = { tolerance, durationMs, windowMs: windowOf(module) };
  const compared = await compareCaseOutputs(theCase.outputs, outputs, exactness);
  const isPassed = fault === undefined && compared.length > 0 && compared.every(isSame);
  return { isPassed, topics: compared, fault };
}

/** Two runs, and no less than a busy node is late. */
function windowOf({ processingMode }: ProcessingModule): number | undefined {
  if (processingMode?.triggerOnInput) return undefined;
  const hertz = processingMode?.frequency?.hertz;
  return Math.max(MIN_WINDOW_MS, 2 * (hertz ? 1000 / hertz : PASS_MS));
}
