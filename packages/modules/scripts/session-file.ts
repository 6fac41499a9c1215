import { toJson, type Init, type JsonValue, type Session } from '@ubii/proto';

/** Text of the file of an example session: JSON as the services take it, without what it leaves open. */
export function sessionFile(session: Init<Session>): string {
  const json = withoutDefaults(toJson('ubii.sessions.Session', session), session);
  return `${JSON.stringify(json, null, 2)}\n`;
}

/** Drops the members that the message does not have: the JSON has the default of each. */
function withoutDefaults(json: JsonValue, message: unknown): JsonValue {
  if (typeof json !== 'object' || json === null) return json;
  if (Array.isArray(json)) {
    return json.map((element, i) => withoutDefaults(element, (message as unknown[])[i]));
  }
  const members = message as { readonly [member: string]: unknown };
  return Object.fromEntries(
    Object.entries(json)
      .filter(([name]) => members[name] !== undefined)
      .map(([name, value]) => [name, withoutDefaults(value, members[name])]),
  );
}
