/** A request to identify this device. */
export interface IdentifyCall {
  /** Name of the requesting client, in one line; empty when unknown. */
  readonly byName: string;
}

/** Last request that was shown, so that the value on the topic is not taken for a new one. */
export interface SeenCall {
  load(): string | null;
  save(call: string): void;
}

/** Longest name, characters; longer ones are cut. */
const MAX_NAME = 60;

/**
 * Returns new requests only: the value stays on its topic, and is received again with every reload and reconnect.
 * [EX-34] [TD-24]
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
