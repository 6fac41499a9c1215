/**
 * Editor data for a copy of a session whose modules have new ids: positions, wires, and bypassed and muted modules
 * refer to the new ids. Texts that are not JSON are unchanged.
 * @param ids new ids by old ones; ids of bypassed and muted modules are added to it
 */
export function copiedEditorData(
  editorJson: string,
  ids: Map<string, string>,
  uuid: () => string,
): string {
  const json = parsed(editorJson);
  if (json === undefined) return editorJson;
  for (const id of asideIds(json)) if (!ids.has(id)) ids.set(id, uuid());
  return JSON.stringify(renamed(json, ids, ''));
}

function parsed(text: string): unknown {
  if (text === '') return undefined;
  try {
    return JSON.parse(text) as unknown;
  } catch {
    return undefined;
  }
}

type Members = Readonly<Record<string, unknown>>;
const isMembers = (value: unknown): value is Members =>
  typeof value === 'object' && value !== null && !Array.isArray(value);

function asideIds(json: unknown): string[] {
  const aside = isMembers(json) && isMembers(json.aside) ? json.aside : undefined;
  const modules: readonly unknown[] = Array.isArray(aside?.modules) ? aside.modules : [];
  return modules.flatMap((one) => {
    const id = isMembers(one) && isMembers(one.module) ? one.module.id : undefined;
    return typeof id === 'string' && id !== '' ? [id] : [];
  });
}

/** Members whose value is the id of a module; in other members it follows `module:`. */
const ID_MEMBERS: ReadonlySet<string> = new Set(['id', 'moduleId', 'processingModuleId']);

function renamed(value: unknown, ids: ReadonlyMap<string, string>, member: string): unknown {
  if (typeof value === 'string') {
    return ID_MEMBERS.has(member) ? (ids.get(value) ?? value) : nodeIdsIn(value, ids);
  }
  if (Array.isArray(value)) return value.map((one) => renamed(one, ids, ''));
  if (!isMembers(value)) return value;
  return Object.fromEntries(
    Object.entries(value).map(([name, inner]) => [nodeIdsIn(name, ids), renamed(inner, ids, name)]),
  );
}

/** Ids of nodes and wires contain the ids of modules. */
function nodeIdsIn(text: string, ids: ReadonlyMap<string, string>): string {
  return text.replaceAll(/module:(\S+)/g, (all, id: string) => {
    const next = ids.get(id);
    return next === undefined ? all : `module:${next}`;
  });
}
