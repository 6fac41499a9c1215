/** A client as its display name is made: what it calls itself, and whether it is in the master's list. */
export interface NamedClient {
  readonly id: string;
  /** As the master has it; may be empty, and other clients may have the same. */
  readonly name: string;
  readonly isPresent: boolean;
}

const UUID = /^[0-9a-f]{8}(-[0-9a-f]{4}){3}-[0-9a-f]{12}$/i;

/** Whether a text has the form of the ids that the master gives to clients. */
export function isClientId(text: string): boolean {
  return UUID.test(text);
}

/** What a client without a name is called: `Client 9b2f9c1e`. */
export function unnamedClient(id: string): string {
  return `Client ${id.slice(0, 8)}`;
}

/**
 * Returns a display name for each client by its id, no two alike: of clients with the same name, the first keeps it and
 * the others get a number, `Phone`, `Phone 2`. A client keeps its display name as long as it keeps its own name; clients
 * that are gone give up theirs to those that are here.
 *
 * @param clients in the order in which this page learned of them
 * @param before the result of the call before
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

/** Whether a display name was made from the name that the client has now. */
function isNameOf(display: string, client: NamedClient): boolean {
  const base = baseOf(client);
  return (
    display === base ||
    (display.startsWith(`${base} `) && /^ \d+$/.test(display.slice(base.length)))
  );
}
