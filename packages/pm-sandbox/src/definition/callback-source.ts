/** Names a bundler may give to the function that keeps the names of functions. */
const KEEP_NAME = '__name';

/** `async`, then: `function`, a parenthesis of an arrow function, or its only parameter. */
const EXPRESSION = /^(?:async\b\s*)?(?:function\b|\(|[\p{ID_Start}$_][\p{ID_Continue}$]*\s*=>)/u;

/**
 * Source text of a function that evaluates, as an expression, to that function. [PM-2]
 *
 * @param name the property it was found under
 * @throws TypeError for functions that have no source of their own (bound and native ones)
 */
export function callbackSource(fn: unknown, name: string): string {
  if (typeof fn !== 'function') {
    throw new TypeError(`${name} must be a function, got ${typeof fn}.`);
  }
  const text = Function.prototype.toString.call(fn);
  if (/\{\s*\[native code\]\s*\}$/.test(text)) {
    throw new TypeError(`${name} is bound or native: there is no source that could be sent.`);
  }
  return withKeepName(EXPRESSION.test(text) ? text : methodSource(text, fn.name || name));
}

/** A method's text is none of its own: it makes sense in an object only. */
function methodSource(text: string, name: string): string {
  return `({ ${text} })[${JSON.stringify(name)}]`;
}

/** Build tools that keep names call a function which is not there where the text arrives. */
function withKeepName(text: string): string {
  return text.includes(`${KEEP_NAME}(`) ? `((${KEEP_NAME}) => (${text}))((fn) => fn)` : text;
}
