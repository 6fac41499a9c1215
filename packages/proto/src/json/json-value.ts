/** A JSON object as `JSON.parse` makes it. */
export type JsonObject = { [key: string]: JsonValue };

/** Any JSON value. */
export type JsonValue = null | boolean | number | string | JsonValue[] | JsonObject;
