import { StatusEventKind, type StatusEvent } from '@ubii/proto';

/** Way in which a client left: it deregistered, an admin removed it, or its connection was lost. [EX-55] */
export type GoneHow = 'left' | 'disconnected' | 'lost';

/** A client that is no longer listed. */
export interface GoneClient {
  readonly clientId: string;
  readonly how: GoneHow;
  /** Description by the master: `Mara left`. */
  readonly text: string;
  /** Time, epoch milliseconds of the master's clock. */
  readonly atMs: number;
}

const HOW: Partial<Record<StatusEvent['kind'], GoneHow>> = {
  [StatusEventKind.CLIENT_LEFT]: 'left',
  [StatusEventKind.CLIENT_DISCONNECTED]: 'disconnected',
  [StatusEventKind.CLIENT_LOST]: 'lost',
};
/** Events that say nothing about the presence of a client. */
const BESIDE_THE_POINT: ReadonlySet<StatusEvent['kind']> = new Set([
  StatusEventKind.CLIENT_RENAMED,
  StatusEventKind.CLIENT_THROTTLED,
  StatusEventKind.LIMIT_REACHED,
  StatusEventKind.OVERLOAD,
]);

/**
 * Returns the clients that left recently, latest first.
 * @param events oldest first
 * @param isListed whether a client is listed; such clients are skipped
 */
export function goneLately(
  events: readonly StatusEvent[],
  isListed: (clientId: string) => boolean,
): GoneClient[] {
  const gone = new Map<string, GoneClient | undefined>();
  for (const { kind, clientId, text, timeMs } of events.toReversed()) {
    if (clientId === '' || gone.has(clientId) || BESIDE_THE_POINT.has(kind)) continue;
    const how = HOW[kind];
    const isGone = how !== undefined && !isListed(clientId);
    gone.set(clientId, isGone ? { clientId, how, text, atMs: timeMs } : undefined);
  }
  return [...gone.values()].filter((one) => one !== undefined);
}
