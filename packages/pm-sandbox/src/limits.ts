const KIB = 1024;
const MIB = 1024 * KIB;

/** Limits of a node's modules. Units are in the names; rates are those of one instance. */
export interface RuntimeLimits {
  /** Frequency of a module, runs a second. [PM-20] */
  readonly maxFrequencyHz: number;
  /** Runs a second of a module in free mode. [PM-28] */
  readonly maxFreeHz: number;
  /**
   * Timeout of a run in progress when its instance is halted, and of onHalted and onDestroyed each, milliseconds.
   * [PM-29]
   */
  readonly haltTimeoutMs: number;
  /** Topics in the list of one muxer. [PM-44] */
  readonly maxMuxElements: number;
  /** Events of one input that wait for a run of a module that they trigger. [PM-25] */
  readonly maxWaitingEvents: number;
  /** Time that matching the patterns of one session's muxers may take at once. [PM-71] */
  readonly patternMatchMs: number;
  /** The same per second in the long run. [PM-71] */
  readonly patternMatchMsPerSecond: number;
  /** Topics that the demuxers of one instance make. [SE-61] */
  readonly maxTopics: number;
  /** A topic that no demuxer wrote for this long ends for another one at the limit. [SE-61] */
  readonly topicRestMs: number;
  /** Records put out. [PM-55] */
  readonly maxOutputsPerSecond: number;
  /** Bytes of the records put out. [PM-55] */
  readonly maxOutputBytesPerSecond: number;
  /** Lines written to the console. [PM-55] */
  readonly maxLogLinesPerSecond: number;
  /** Different events in a second; what is beyond is only counted. [PM-81] */
  readonly maxEventsPerSecond: number;
  /** Restarts of a killed instance within `restartWindowMs`. [PM-54] */
  readonly maxRestarts: number;
  /** Time window of `maxRestarts`. */
  readonly restartWindowMs: number;
  /** Delay of the first restart; each further one in the window waits twice as long. [PM-54] */
  readonly restartDelayMs: number;
  /** Longest delay of a restart. */
  readonly maxRestartDelayMs: number;
  /** A call that takes longer ends the instance. [PM-53] */
  readonly callTimeoutMs: number;
  /** Memory of one instance. [PM-52] */
  readonly memoryBytes: number;
  /** Bytes of all outputs of one run. */
  readonly outputBytes: number;
}

/** Default limits of a node. */
export const DEFAULT_RUNTIME_LIMITS: RuntimeLimits = {
  // Timers of browsers and Node have a resolution of 1 ms, and a run crosses two threads: beyond this
  // the intervals are noise.
  maxFrequencyHz: 240,
  // As fast as the fastest screens; leaves a forwarding thread that also serves others its turns.
  maxFreeHz: 240,
  // Stopping a session waits for it, and a master waits 10 s for its nodes (SE-13).
  haltTimeoutMs: 2_000,
  // As many players as a master takes clients, with room for their list in one message.
  maxMuxElements: 4_096,
  // A chord on a keyboard and a fast hand: more is a stream, and a module that cannot follow it would act late.
  maxWaitingEvents: 64,
  // Some 2 µs for a topic: four full muxers of ordinary patterns, when a session starts.
  patternMatchMs: 100,
  // As the master gives each client: a twentieth of the thread.
  patternMatchMsPerSecond: 50,
  // One for each element that a muxer takes in.
  maxTopics: 4_096,
  // Players who left are not written any more; players who stand still are, by modules that run often.
  topicRestMs: 60_000,
  // A tenth of what a master forwards for everybody.
  maxOutputsPerSecond: 20_000,
  // Raw full-HD pictures at 15 Hz.
  maxOutputBytesPerSecond: 128 * MIB,
  // One line per run at 30 Hz, and bursts. More lines cannot be read.
  maxLogLinesPerSecond: 50,
  // Equal ones are one; so many different ones are made by a loop.
  maxEventsPerSecond: 100,
  // A module that is killed once a minute by an unlucky input recovers; one that always is does not.
  maxRestarts: 5,
  restartWindowMs: 60_000,
  // With doubling, five restarts take 250 ms to 4 s: the window sees them all.
  restartDelayMs: 250,
  maxRestartDelayMs: 10_000,
  // A second is what PM-53 promises from the loop to its end.
  callTimeoutMs: 500,
  // A full-HD picture decoded and some copies.
  memoryBytes: 64 * MIB,
  // One raw 4K picture, what one frame of the master may hold.
  outputBytes: 32 * MIB,
};
