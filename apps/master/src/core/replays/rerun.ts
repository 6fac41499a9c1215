import type { PatternCompiler } from '@ubii/patterns';
import {
  ServiceError,
  type Recording,
  type RecordingSelection,
  type ReplayedSession,
} from '@ubii/proto';
import { devicesByTopic, type RecordedDevice, type Span } from '@ubii/recording';
import type { Cancel, Clock } from '@ubii/timing';
import { shortened } from '@ubii/words';
import type { GrantId } from '../access/grant.ts';
import type { LimitWatch } from '../counters/limit-watch.ts';
import type { ModuleLibrary } from '../library/module-library.ts';
import type { ReplayFile } from '../ports/replay-files.ts';
import type { Recordings } from '../recordings/recordings.ts';
import type { Session } from '../sessions/session.ts';
import type { Sessions } from '../sessions/sessions.ts';
import { quote } from '../texts/quote.ts';
import type { RecordedSource } from '../topics/recorded-sources.ts';
import { recordedSession } from './recorded-session.ts';
import { RerunInputs, type RerunInputsContext } from './rerun-inputs.ts';
import { rerunSession, type RerunSession } from './rerun-session.ts';

/** What running a session again works with. */
export interface RerunContext extends RerunInputsContext {
  readonly clock: Clock;
  readonly limitWatch: LimitWatch;
  readonly patterns: PatternCompiler;
  readonly sessions: Sessions;
  readonly modules: ModuleLibrary;
  readonly recordings: Recordings;
}

/** Which session of which recording. */
export interface RerunWish {
  readonly replayId: string;
  readonly sessionId: string;
  readonly recording: Recording;
  readonly author: string;
  /** Whose the comparison is. [RC-66] */
  readonly makerId: string;
  /** Invitation of the session; empty for none. [AC-90] */
  readonly grantId: GrantId | undefined;
}

interface PreparedRerun {
  readonly rerun: RerunSession;
  readonly file: ReplayFile;
  readonly devices: readonly RecordedDevice[];
}

/** Time for modules to handle the last inputs, milliseconds. */
const LAST_OUTPUTS_MS = 500;
/** Turns of the event loop in which a session comes to run, some seconds. */
const MAX_TURNS = 5_000;

/** A recorded session that runs again on replayed inputs. [RP-40] [RP-41] */
export class Rerun {
  readonly #context: RerunContext;
  readonly #wish: RerunWish;
  readonly #rerun: RerunSession;
  readonly #inputs: RerunInputs;
  /** Why inputs that select components stay empty. */
  readonly #whyEmpty: string;
  #session: Session | undefined = undefined;
  #comparisonId: string | undefined = undefined;
  #cancel: Cancel | undefined = undefined;
  /** The first error of each module, also of those that are repaired. */
  readonly #errors = new Map<string, string>();
  #isOver = false;

  private constructor(
    context: RerunContext,
    wish: RerunWish,
    { rerun, file, devices }: PreparedRerun,
  ) {
    this.#context = context;
    this.#wish = wish;
    this.#rerun = rerun;
    this.#inputs = new RerunInputs(context, rerun.selected, this.#sourcesOf(file, devices));
    this.#whyEmpty =
      devices.length === 0 ? 'the recording has no devices' : 'no recorded component fits';
  }

  /** @throws ServiceError when the recording has no such session */
  static async prepare(context: RerunContext, wish: RerunWish, file: ReplayFile, span: Span) {
    const recorded = await file.session(wish.sessionId, span.fromNs);
    if (recorded === undefined) {
      throw new ServiceError(
        'not_found',
        `The recording ${quote(wish.recording.name)} has no session with the id ${quote(wish.sessionId)}.`,
      );
    }
    const message = recordedSession(recorded, context.limitWatch);
    const devices = await file.devices(span);
    const rerun = rerunSession(message, {
      devices,
      replayId: wish.replayId,
      inputPrefix: prefixOf(wish.replayId, 'in'),
      outputPrefix: prefixOf(wish.replayId, 'out'),
      patterns: context.patterns,
      isInLibrary: (name) => context.modules.get(name) !== undefined,
    });
    return new Rerun(context, wish, { rerun, file, devices });
  }

  get inputPrefix(): string {
    return prefixOf(this.#wish.replayId, 'in');
  }

  /** Inputs that stay empty, then modules that do not run or whose runs fail; empty when there are none. */
  get problem(): string {
    this.#noteErrors();
    const { emptyInputs } = this.#rerun;
    const empty =
      emptyInputs.length === 0
        ? []
        : [
            `Inputs that select components stay empty, because ${this.#whyEmpty}: ${emptyInputs.join(', ')}.`,
          ];
    const { eventCharacters } = this.#context.limitWatch.limits;
    return shortened([...empty, ...this.#errors.values()].join(' '), eventCharacters);
  }

  /** Whether the session reads this recorded topic. */
  readsTopic(topic: string): boolean {
    return this.#rerun.readsTopic(topic);
  }

  /** Starts the session and the recording of its topics. @throws ServiceError when it cannot run */
  async start(): Promise<void> {
    const { sessions, recordings } = this.#context;
    const { replayId, recording, author, makerId, grantId } = this.#wish;
    const { name } = this.#rerun.session;
    const selection: RecordingSelection = {
      topics: [],
      clients: [],
      devices: [],
      sessions: [],
      excludedPatterns: [],
      patterns: [`/replays/${replayId}/**`],
      withoutImages: false,
    };
    const wish = { name: `${name} in ${recording.name}`, notes: '', author, makerId };
    this.#inputs.open();
    try {
      this.#session = await sessions.start(this.#rerun.session, grantId);
      await this.#untilItRuns(this.#session);
      // It has data of the participant, and is deleted with it. [ST-51]
      const { id: replayedRecordingId, study } = recording;
      const comparison = { ...wish, replayedRecordingId, ...(study && { study }) };
      const { id } = await recordings.start(comparison, { selection });
      this.#comparisonId = id;
    } finally {
      // The replay was stopped meanwhile.
      if (this.#isOver) this.#end();
    }
  }

  /** The inputs are over: ends it when the last outputs are there. */
  finish(onOver: () => void): void {
    if (this.#isOver) return;
    this.#cancel ??= this.#context.clock.after(LAST_OUTPUTS_MS, () => {
      this.close();
      onOver();
    });
  }

  /** Removes the session and closes the recording. */
  close(): void {
    if (this.#isOver) return;
    this.#isOver = true;
    this.#cancel?.();
    this.#end();
  }

  toMessage(): ReplayedSession {
    const { replayId, sessionId } = this.#wish;
    return {
      sessionId,
      name: this.#rerun.session.name,
      runningId: this.#isOver ? '' : (this.#session?.id ?? ''),
      comparisonRecordingId: this.#comparisonId ?? '',
      inputPrefix: prefixOf(replayId, 'in'),
      outputPrefix: prefixOf(replayId, 'out'),
      recordedModules: [...this.#rerun.recordedModules],
    };
  }

  #end(): void {
    const { sessions, recordings } = this.#context;
    this.#noteErrors();
    if (this.#comparisonId !== undefined) {
      void recordings.stop(this.#comparisonId).catch(() => undefined); // It was deleted meanwhile.
    }
    const session = this.#session;
    this.#session = undefined;
    this.#inputs.close();
    if (session !== undefined && sessions.isOpen(session.id)) sessions.remove(session);
  }

  /** Of the topics that the session reads, as it reads them; not of those on which several clients published. */
  #sourcesOf({ facts }: ReplayFile, devices: readonly RecordedDevice[]) {
    const deviceOf = devicesByTopic(devices);
    const sources = new Map<string, RecordedSource>();
    const shared = new Set<string>();
    for (const { topic, clientId } of facts.topics) {
      if (!this.readsTopic(topic)) continue;
      const path = this.inputPrefix + topic;
      if (sources.has(path)) shared.add(path);
      sources.set(path, { clientId, deviceId: deviceOf.get(topic) ?? '' });
    }
    for (const path of shared) sources.delete(path);
    return sources;
  }

  #noteErrors(): void {
    for (const { isError, moduleId, message } of this.#session?.problems() ?? []) {
      if (isError && !this.#errors.has(moduleId)) this.#errors.set(moduleId, message);
    }
  }

  async #untilItRuns(session: Session): Promise<void> {
    for (let turn = 0; turn < MAX_TURNS && session.life === 'starting'; turn++) {
      await new Promise<void>((resolve) => void this.#context.clock.after(0, resolve));
    }
    if (session.life === 'running') return;
    const [problem] = session.problems();
    throw new ServiceError(
      'failed_precondition',
      `The session ${quote(session.label)} does not run: ${problem?.message ?? `it is ${session.life}.`}`,
    );
  }
}

function prefixOf(replayId: string, direction: 'in' | 'out'): string {
  return `/replays/${replayId}/${direction}`;
}
