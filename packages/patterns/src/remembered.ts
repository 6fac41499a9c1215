/** Time that may be spent, milliseconds. */
export interface MatchBudget {
  /**
   * Takes what was spent, going into debt if need be.
   * @param nowMs monotonic milliseconds
   * @returns whether something is left
   */
  spend(amountMs: number, nowMs: number): boolean;
}

/** Options for caching results. */
export interface RememberOptions {
  /** Texts whose answer is remembered, the newest ones. @default 8192 */
  readonly maxTexts?: number;
  /** Time budget of matching. @default any time */
  readonly meter?: {
    readonly budget: MatchBudget;
    readonly monotonicMs: () => number;
    /** Subject of the error when the budget is exceeded. */
    readonly source: string;
  };
}

/** Twice what a muxer lists. */
const DEFAULT_MAX_TEXTS = 8_192;

/**
 * Maximum charge of one match, milliseconds: the time of the worst pattern within the limits for one topic. A longer measured time means that the machine was busy.
 */
const LONGEST_MS = 30;

/** The budget is spent: nothing is known of this text until some of it came back. */
export class MatchBudgetError extends Error {
  override readonly name = 'MatchBudgetError';
}

/**
 * Finds the answer for a text once, and not with every record.
 * @param find may take its time; the same text always has the same answer
 * @returns throws a `MatchBudgetError` for a text without an answer while the budget is spent
 */
export function remembered<T>(
  find: (text: string) => T,
  { maxTexts = DEFAULT_MAX_TEXTS, meter }: RememberOptions = {},
): (text: string) => T {
  const found = new Map<string, T>();
  return (text) => {
    if (found.has(text)) return found.get(text) as T;
    const answer = meter === undefined ? find(text) : metered(find, text, meter);
    if (found.size >= maxTexts) {
      const [oldest] = found.keys();
      found.delete(oldest!);
    }
    found.set(text, answer);
    return answer;
  };
}

function metered<T>(
  find: (text: string) => T,
  text: string,
  { budget, monotonicMs, source }: NonNullable<RememberOptions['meter']>,
): T {
  const startedMs = monotonicMs();
  if (!budget.spend(0, startedMs)) {
    throw new MatchBudgetError(`matching ${quote(source)} takes too long`);
  }
  const answer = find(text);
  const endedMs = monotonicMs();
  budget.spend(Math.min(endedMs - startedMs, LONGEST_MS), endedMs);
  return answer;
}

function quote(source: string): string {
  return JSON.stringify(source.length > 60 ? `${source.slice(0, 59)}…` : source);
}
