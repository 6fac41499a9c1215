/** A request to identify this device. */
export interface IdentifyCall {
  /** Name of the requesting client, in one line; empty when unknown. */
  readonly byName: string;
}

/** What a page remembers of it, so that a value that stays on the topic is not taken for a new call. */
export interface SeenCall {
  load(): string | null;
  save(call: string): void;
}

/** Longer names are cut. */
const MAX_NAME = 60;

/**
 * Tells new calls from ones that were shown already: the value stays on its topic, and comes again with
 * every reload and reconnect. [EX-34] [TD-24]
 */
export function readCall(
  record: {
    readonly value: string;
    readonly clientId: string;
    readonly timestampMs: number | undefined;
  },
  seen: SeenCall,
): IdentifyCall | undefined {
  const { value, clientId, timestampMs } = record;
  if (timestampMs !== undefined) {
    const call = `${clientId} ${timestampMs}`;
    if (seen.load() === call) return undefined;
    seen.save(call);
  }
  const line = value.replace(/\s+/g, ' ').trim();
  return { byName: line.length > MAX_NAME ? `${line.slice(0, MAX_NAME)}…` : line };
}
