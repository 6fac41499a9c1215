import { MeteredPatterns, type PatternCompiler } from '@ubii/patterns';
import { MuxIdentity, type IOMapping, type TopicMux } from '@ubii/proto';
import { TokenBucket, type Clock } from '@ubii/timing';
import type { RuntimeLimits } from '../../limits.ts';
import { muxSelector } from './mux-selector.ts';

/** Sessions whose budget is remembered. One that is forgotten begins with a full one. */
const MAX_SESSIONS = 1_024;

/** The patterns of muxers, with one budget of time for each session. [PM-71] */
export class SessionPatterns {
  readonly #patterns: PatternCompiler;
  readonly #clock: Pick<Clock, 'monotonicMs'>;
  readonly #limits: PatternTimes;
  readonly #sessions = new Map<string, MeteredPatterns>();

  constructor(patterns: PatternCompiler, clock: Pick<Clock, 'monotonicMs'>, limits: PatternTimes) {
    this.#patterns = patterns;
    this.#clock = clock;
    this.#limits = limits;
  }

  of(sessionId: string): MeteredPatterns {
    let patterns = this.#sessions.get(sessionId);
    if (patterns === undefined) {
      patterns = this.#create();
      if (this.#sessions.size >= MAX_SESSIONS) {
        const [oldest] = this.#sessions.keys();
        this.#sessions.delete(oldest!);
      }
      this.#sessions.set(sessionId, patterns);
    }
    return patterns;
  }

  #create(): MeteredPatterns {
    const { patternMatchMs, patternMatchMsPerSecond } = this.#limits;
    const monotonicMs = (): number => this.#clock.monotonicMs();
    return new MeteredPatterns(this.#patterns, {
      budget: new TokenBucket(patternMatchMsPerSecond, monotonicMs(), patternMatchMs),
      monotonicMs,
    });
  }
}

/** Time limits of matching. */
export type PatternTimes = Pick<RuntimeLimits, 'patternMatchMs' | 'patternMatchMsPerSecond'>;

/** Whether a muxer matches regular expressions, so that there has to be a compiler of them. */
export function muxNeedsPatterns(mux: TopicMux): boolean {
  const { identitySource, identityMatchPattern } = mux;
  return (
    muxSelector(mux)?.kind === 'regex' ||
    (identitySource === MuxIdentity.MUX_IDENTITY_PATTERN && identityMatchPattern !== '')
  );
}

/** Whether any input of a mapping does. */
export function mappingNeedsPatterns({ inputMappings }: IOMapping): boolean {
  return inputMappings.some(({ topicMux }) => topicMux !== undefined && muxNeedsPatterns(topicMux));
}
