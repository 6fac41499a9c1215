const TAG = 'bridge to ';

/** Tag of a bridge, by which others know which system it leads to. [BR-22] */
export function bridgeTag(system: string): string {
  return `${TAG}${system}`;
}

/** What is known of a client. */
export interface KnownClient {
  readonly id: string;
  readonly tags: readonly string[];
  readonly isGone: boolean;
}

/** Clients of the master that are bridges to the same system. What they publish came from there. [BR-22] */
export class OtherBridges {
  readonly #tag: string;
  readonly #ids = new Set<string>();

  constructor(system: string) {
    this.#tag = bridgeTag(system);
  }

  handleClient({ id, tags, isGone }: KnownClient): void {
    if (!isGone && tags.includes(this.#tag)) this.#ids.add(id);
    else this.#ids.delete(id);
  }

  has(clientId: string): boolean {
    return this.#ids.has(clientId);
  }
}
