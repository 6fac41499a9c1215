import type { RuntimeLimits } from '../limits.ts';
import type { TopicPort } from '../ports/topic-port.ts';

/**
 * The topics that the demuxers of one instance made. At the limit, a topic that was not written for a
 * while ends; when none rests, new topics are refused while the others go on. [SE-61]
 */
export class MadeTopics {
  readonly #port: Pick<TopicPort, 'makeTopic' | 'endTopics'>;
  readonly #sessionId: string;
  readonly #limits: Pick<RuntimeLimits, 'maxTopics' | 'topicRestMs'>;
  /** When each was written last, monotonic milliseconds; those that rest longest come first. */
  readonly #writtenMs = new Map<string, number>();

  constructor(
    port: Pick<TopicPort, 'makeTopic' | 'endTopics'>,
    sessionId: string,
    limits: Pick<RuntimeLimits, 'maxTopics' | 'topicRestMs'>,
  ) {
    this.#port = port;
    this.#sessionId = sessionId;
    this.#limits = limits;
  }

  get count(): number {
    return this.#writtenMs.size;
  }

  /** A demuxer writes a topic. @returns why it may not, as a sentence without its end */
  write(topic: string, nowMs: number): string | undefined {
    if (!this.#writtenMs.delete(topic)) {
      const refusal = this.#make(topic, nowMs);
      if (refusal !== undefined) return refusal;
    }
    this.#writtenMs.set(topic, nowMs);
    return undefined;
  }

  /** Ends topics that are not written any more. [SE-62] */
  end(): void {
    const topics = [...this.#writtenMs.keys()];
    this.#writtenMs.clear();
    if (topics.length > 0) this.#port.endTopics?.(topics, this.#sessionId);
  }

  #make(topic: string, nowMs: number): string | undefined {
    const { maxTopics, topicRestMs } = this.#limits;
    if (this.#writtenMs.size >= maxTopics) {
      const [oldest] = this.#writtenMs;
      if (oldest === undefined || nowMs - oldest[1] < topicRestMs) {
        return `the demuxers of one module make at most ${maxTopics} topics`;
      }
      this.#writtenMs.delete(oldest[0]);
      this.#port.endTopics?.([oldest[0]], this.#sessionId);
    }
    return this.#port.makeTopic?.(topic, this.#sessionId);
  }
}
