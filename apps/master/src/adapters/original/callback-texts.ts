/*
 * Source texts that run in the sandbox of a module, around code that was written for the original.
 */

/** Calls a callback `(deltaTime, inputs, outputs, state)` as `(deltaTime, inputs, state)`: `members` of its outputs. */
export const FOUR_PARAMETERS = oneLine(`
  ((fn, members) => function (deltaTime, inputs, state) {
    const values = {};
    for (const name of Object.keys(inputs)) {
      const record = inputs[name];
      values[name] = record && record.type ? record[record.type] : record;
    }
    const outputs = {};
    const asRecord = (name) => {
      const value = outputs[name];
      const member = members[name];
      const isObject = typeof value === 'object' && value !== null;
      const isRecord = isObject && member in value;
      const isDemuxed = isObject && Array.isArray(value.elements)
        && value.elements.some((each) => each && each.outputTopicParams);
      return member === undefined || value === undefined || isRecord || isDemuxed
        ? value
        : { [member]: value };
    };
    const take = () => ({
      outputs: Object.fromEntries(Object.keys(outputs).map((name) => [name, asRecord(name)])),
    });
    const result = fn.call(this, deltaTime, values, outputs, state);
    return result && typeof result.then === 'function' ? result.then(take) : take();
  })`);

/**
 * Makes a callback, or the description, of a class that a CommonJS text exports. The object of the class is kept in the
 * state of the instance, under a symbol.
 */
export const CLASS_MODULE = oneLine(`
  ((phase, members, constants, adapt, define) => {
    const KEY = Symbol.for('original module');
    const PHASES = ['onCreated', 'onProcessing', 'onHalted', 'onDestroyed'];
    class ProcessingModule {
      constructor(specs) { Object.assign(this, specs); this.state = {}; }
      onCreated() {}
      onProcessing() {}
      onHalted() {}
      onDestroyed() {}
      toProtobuf() { return this; }
    }
    ProcessingModule.ProcessingModule = ProcessingModule;
    const say = (level) => (...words) => console[level](words.join(': '));
    const log = {
      log: say('info'), logSuccess: say('info'), info: say('info'), warn: say('warn'),
      logWarn: say('warn'), logFailure: say('error'), error: say('error'),
    };
    const require = (name) => {
      if (/(^|[/])processingModule([.]js)?$/.test(name)) return ProcessingModule;
      if (/^@tum-far[/]ubii-node-/.test(name)) return ProcessingModule;
      if (/^@tum-far[/]ubii-msg-formats/.test(name)) return constants;
      if (/^@tum-far[/]namida/.test(name)) return log;
      throw new Error('It requires "' + name + '", which a sandbox does not have.');
    };
    const make = () => {
      const module = { exports: {} };
      define.call(module.exports, module, module.exports, require);
      const Module = module.exports.default || module.exports;
      if (typeof Module !== 'function') throw new Error('It exports no class: set module.exports to the class of the module.');
      return new Module();
    };
    const describe = (made) => ({
      name: made.name, description: made.description, authors: made.authors, tags: made.tags,
      inputs: made.inputs, outputs: made.outputs, processingMode: made.processingMode,
      callbacks: PHASES.filter((each) =>
        typeof made[each] === 'function' && made[each] !== ProcessingModule.prototype[each]),
    });
    if (phase === 'describe') {
      return () => ({ outputs: { description: { string: JSON.stringify(describe(make())) } } });
    }
    const keep = (state, made) => Object.defineProperty(state, KEY, { value: made, configurable: true });
    const madeOf = (state) => {
      const made = state[KEY] || make();
      if (!state[KEY]) keep(state, made);
      made.state = state;
      return made;
    };
    if (phase !== 'onProcessing') return (state) => madeOf(state)[phase](state);
    return (deltaTime, inputs, state) => {
      const made = madeOf(state);
      const take = (result) => {
        const next = (result && result.state) || made.state;
        if (next === state) return result;
        keep(next, made);
        return { ...result, state: next };
      };
      const fn = made.onProcessing.length >= 4 ? adapt(made.onProcessing, members) : made.onProcessing;
      const result = fn.call(made, deltaTime, inputs, state);
      return result && typeof result.then === 'function' ? result.then(take) : take(result);
    };
  })`);

/**
 * Text of an expression made of another one, `given`, which stands first: faults name its lines, and who reads the code
 * begins with it.
 */
export function around(given: string, expression: string): string {
  return `[${given}\n].map((given) => ${expression})[0]`;
}

function oneLine(text: string): string {
  return text.trim().replace(/\s*\n\s*/g, ' ');
}
