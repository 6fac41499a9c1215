import { StatusEventKind, type Client, type StatusEvent, type StatusProblem } from '@ubii/proto';

/**
 * Returns the time since which a client is away, epoch milliseconds of the master's clock; `undefined` when it is
 * present or the time is unknown.
 * @param events oldest first
 */
export function awaySinceMs(
  clientId: string,
  problems: readonly StatusProblem[],
  events: readonly StatusEvent[],
): number | undefined {
  const problem = problems.find(
    (candidate) => candidate.code === 'client_silent' && candidate.clientId === clientId,
  );
  if (problem) return problem.sinceMs;
  const lost = events.findLast((event) => event.clientId === clientId);
  return lost?.kind === StatusEventKind.CLIENT_LOST ? lost.timeMs : undefined;
}

/** Kind of a client in a few words: from its own description, otherwise from its properties. */
export function clientKind(client: Client): string {
  const words = client.description.trim() || client.tags.join(', ');
  if (words !== '') return words;
  return client.isDedicatedProcessingNode ? 'runs modules' : '';
}
