/** A JSON object as `JSON.parse` makes it. */
export type JsonObject = { [key: string]: JsonValue };

/**
 * Any JSON value. Text stands before truth values: Vue takes the order of a prop's types as the
 * order to try, and with `boolean` first it makes `true` of an empty text.
 */
export type JsonValue = null | string | number | boolean | JsonValue[] | JsonObject;
