/** Data for a client's display name: its own name, and whether it is listed. */
export interface NamedClient {
  readonly id: string;
  /** Name stored on the master; may be empty or not unique. */
  readonly name: string;
  readonly isPresent: boolean;
}

const UUID = /^[0-9a-f]{8}(-[0-9a-f]{4}){3}-[0-9a-f]{12}$/i;

/** Whether a text has the form of a client id. */
export function isClientId(text: string): boolean {
  return UUID.test(text);
}

/** Display name of a client without a name: `Client 9b2f9c1e`. */
export function unnamedClient(id: string): string {
  return `Client ${id.slice(0, 8)}`;
}

/**
 * Returns unique display names of clients by id: of clients with the same name, the first keeps it, and the others get
 * a number, `Phone`, `Phone 2`. A client keeps its display name while its own name is unchanged; disconnected clients
 * give theirs up to connected ones.
 *
 * @param clients in the order in which this page learned of them
 * @param before result of the previous call
 */
export function displayNames(
  clients: readonly NamedClient[],
  before: ReadonlyMap<string, string> = new Map(),
): Map<string, string> {
  const own = new Set(clients.filter(({ isPresent }) => isPresent).map(({ name }) => name));
  const taken = new Set<string>();
  const names = new Map<string, string>();
  const take = (id: string, name: string): void => {
    taken.add(name);
    names.set(id, name);
  };
  for (const isPresent of [true, false]) {
    const group = clients.filter((client) => client.isPresent === isPresent);
    const rest: NamedClient[] = [];
    for (const client of group) {
      const last = before.get(client.id);
      if (last !== undefined && !taken.has(last) && isNameOf(last, client)) take(client.id, last);
      else rest.push(client);
    }
    for (const client of rest) {
      const base = baseOf(client);
      let name = base;
      for (let number = 2; taken.has(name) || (name !== base && own.has(name)); number++) {
        name = `${base} ${number}`;
      }
      take(client.id, name);
    }
  }
  return names;
}

function baseOf({ id, name }: NamedClient): string {
  return name.trim() === '' ? unnamedClient(id) : name;
}

/** Whether a display name was derived from the client's current name. */
function isNameOf(display: string, client: NamedClient): boolean {
  const base = baseOf(client);
  return (
    display === base ||
    (display.startsWith(`${base} `) && /^ \d+$/.test(display.slice(base.length)))
  );
}
