import type { PatternCompiler } from '@ubii/patterns';
import type { SandboxFactory } from '@ubii/pm-sandbox';
import type { ProcessingModule } from '@ubii/proto';
import { devicesByTopic, topicsOfProfile } from '@ubii/recording';
import { decodedOutput, type TopicComparison } from '@ubii/recording/compare';
import { caseTimeNs, compareCaseOutputs, isSame, type CaseOutput } from './compare-outputs.ts';
import { encodeCaseRecord, type CaseRecord, type ModuleCase } from './module-case.ts';
import { PASS_MS, SteppedRun } from './stepped-run.ts';

/** What a case came to. */
export interface CaseResult {
  readonly isPassed: boolean;
  readonly topics: readonly TopicComparison[];
  /** The first error of the module. */
  readonly fault: string | undefined;
}

const MIN_WINDOW_MS = 100;

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
  const outputs: CaseOutput[] = [];
  const { startMs, mapping, devices } = theCase;
  const deviceIds = devicesByTopic(devices);
  const run = new SteppedRun({
    module,
    mapping,
    startMs,
    sandboxes,
    patterns,
    components: {
      topicsOf: (profile) => topicsOfProfile(profile, devices),
      deviceOf: (topic) => deviceIds.get(topic),
    },
    onOutput(topic, bytes, atMs) {
      const record = decodedOutput(bytes);
      if (record !== undefined) outputs.push({ topic, timeNs: caseTimeNs(atMs), record });
    },
  });
  const put = (record: CaseRecord): void =>
    run.put(record.topic, encodeCaseRecord(record), record.publisherId);
  let failure: string | undefined;
  try {
    await run.open();
    theCase.before.forEach(put);
    await run.rest();
    // These belong to the time before
    outputs.length = 0;
    run.beginPasses();
    for (const input of theCase.inputs) {
      await run.moveTo(input.atMs);
      put(input);
      await run.rest();
    }
    await run.moveTo(theCase.durationMs);
  } catch (error) {
    failure = (error as { readonly message?: string }).message ?? String(error);
  } finally {
    await run.close();
  }
  const fault = run.fault ?? failure;
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
