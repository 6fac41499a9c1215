import { toJson, type Init, type JsonValue, type Session } from '@ubii/proto';

/** Returns the file of an example session: JSON as the services use it, without default values. */
export function sessionFile(session: Init<Session>): string {
  const json = withoutDefaults(toJson('ubii.sessions.Session', session), session);
  return `${JSON.stringify(json, null, 2)}\n`;
}

/** Removes the members that the message does not have, because the JSON contains their defaults. */
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
