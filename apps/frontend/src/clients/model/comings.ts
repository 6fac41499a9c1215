import { ClientState, StatusEventKind, type Client, type StatusEvent } from '@ubii/proto';

/** A client left, was lost or came back while the page was open. */
export interface Coming {
  /** `lost`: the connection broke without a deregistration. */
  readonly kind: 'left' | 'lost' | 'back';
  readonly clientId: string;
  readonly name: string;
  /** A new client with the name of one that left. */
  readonly isNew?: boolean;
}

/** Compares consecutive lists of clients to report who left, was lost or came back. */
export class Comings {
  #present: ReadonlyMap<string, string> | undefined;
  /** Names of clients that left, by id; latest last. */
  readonly #gone = new Map<string, string>();

  /** Returns the changes since the previous list. The first list reports none. */
  next(clients: readonly Client[]): Coming[] {
    const isLost = ({ state }: Client): boolean => state === ClientState.UNAVAILABLE;
    const lost = new Set(clients.filter(isLost).map(({ id }) => id));
    const here = clients.filter((client) => !isLost(client));
    const present = new Map(here.map(({ id, name }) => [id, name || id]));
    const before = this.#present;
    this.#present = present;
    if (before === undefined) {
      // A client that was lost earlier may come back while the page is open.
      for (const { id, name } of clients.filter(isLost)) this.#gone.set(id, name || id);
      return [];
    }
    const news: Coming[] = [];
    for (const [clientId, name] of before) {
      if (present.has(clientId)) continue;
      this.#gone.set(clientId, name);
      news.push({ kind: lost.has(clientId) ? 'lost' : 'left', clientId, name });
    }
    for (const [clientId, name] of present) {
      if (before.has(clientId)) continue;
      if (this.#gone.delete(clientId)) news.push({ kind: 'back', clientId, name });
      else if (this.#takeName(name)) news.push({ kind: 'back', clientId, name, isNew: true });
    }
    return news;
  }

  #takeName(name: string): boolean {
    const found = [...this.#gone].find(([, gone]) => gone === name);
    return found !== undefined && this.#gone.delete(found[0]);
  }
}

/** @param events oldest first; for removed clients, they name the user */
export function comingWords(coming: Coming, events: readonly StatusEvent[]): string {
  const { kind, name, clientId } = coming;
  if (kind === 'back') {
    return coming.isNew ? `${name} reconnected as a new client.` : `${name} reconnected.`;
  }
  if (kind === 'lost') return `${name} lost its connection.`;
  const last = events.findLast((event) => event.clientId === clientId);
  if (last?.kind === StatusEventKind.CLIENT_DISCONNECTED) return `${last.text}.`;
  return `${name} has left.`;
}
