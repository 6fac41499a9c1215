// Made by `pnpm --filter @ubii/modules generate` from the definitions. Do not change it by hand.
import type { JsonObject } from '@ubii/proto';

/** Every module of the library as JSON, from a to z. */
export const LIBRARY: readonly JsonObject[] = [
  {
    name: 'average-positions',
    authors: ['Ubi-Interact'],
    tags: ['vector', 'muxer', 'demuxer', 'pointer'],
    description:
      'Gives the middle of many positions, and the offset of each of them from the middle.',
    processingMode: {
      frequency: {
        hertz: 30,
      },
    },
    inputs: [
      {
        internalName: 'positions',
        messageFormat: 'ubii.dataStructure.Vector2',
        isRecordList: true,
      },
    ],
    outputs: [
      {
        internalName: 'middle',
        messageFormat: 'ubii.dataStructure.Vector2',
        isRecordList: false,
      },
      {
        internalName: 'count',
        messageFormat: 'int32',
        isRecordList: false,
      },
      {
        internalName: 'offsets',
        messageFormat: 'ubii.dataStructure.Vector2',
        isRecordList: true,
      },
    ],
    language: 'JS',
    onProcessingStringified:
      '({ onProcessing(_deltaTimeMs, inputs) {\n    const usable = (inputs.positions?.elements ?? []).filter(\n      ({ vector2 }) => Math.abs(vector2.x) <= 1e100 && Math.abs(vector2.y) <= 1e100\n    );\n    const count = usable.length;\n    if (count === 0) return { outputs: { count: { int32: 0 } } };\n    const middle = { x: 0, y: 0 };\n    for (const { vector2 } of usable) {\n      middle.x += vector2.x / count;\n      middle.y += vector2.y / count;\n    }\n    const offsets = usable.flatMap(\n      ({ identity, vector2 }) => identity ? [\n        {\n          vector2: { x: vector2.x - middle.x, y: vector2.y - middle.y },\n          outputTopicParams: [identity]\n        }\n      ] : []\n    );\n    return {\n      outputs: {\n        middle: { vector2: middle },\n        count: { int32: count },\n        offsets: { elements: offsets }\n      }\n    };\n  } })["onProcessing"]',
    extension: {
      version: '1.0.0',
      libraries: [],
      replaceable: false,
      origin: 'MODULE_ORIGIN_UNKNOWN',
      grantIds: [],
    },
  },
  {
    name: 'clock',
    authors: ['Ubi-Interact'],
    tags: ['source', 'generator', 'time', 'number'],
    description:
      'Gives a counter, the time that passed, ticks, and sine, square, triangle and saw waves.',
    processingMode: {
      frequency: {
        hertz: 30,
      },
    },
    inputs: [
      {
        internalName: 'waveHz',
        messageFormat: 'double',
        isRecordList: false,
        defaultJson: '{"double":1}',
      },
      {
        internalName: 'amplitude',
        messageFormat: 'double',
        isRecordList: false,
        defaultJson: '{"double":1}',
      },
      {
        internalName: 'offset',
        messageFormat: 'double',
        isRecordList: false,
        defaultJson: '{"double":0}',
      },
      {
        internalName: 'phase',
        messageFormat: 'double',
        isRecordList: false,
        defaultJson: '{"double":0}',
      },
      {
        internalName: 'dutyCycle',
        messageFormat: 'double',
        isRecordList: false,
        defaultJson: '{"double":0.5}',
      },
    ],
    outputs: [
      {
        internalName: 'count',
        messageFormat: 'int32',
        isRecordList: false,
      },
      {
        internalName: 'elapsedMs',
        messageFormat: 'double',
        isRecordList: false,
      },
      {
        internalName: 'tick',
        messageFormat: 'bool',
        isRecordList: false,
      },
      {
        internalName: 'sine',
        messageFormat: 'double',
        isRecordList: false,
      },
      {
        internalName: 'square',
        messageFormat: 'double',
        isRecordList: false,
      },
      {
        internalName: 'triangle',
        messageFormat: 'double',
        isRecordList: false,
      },
      {
        internalName: 'saw',
        messageFormat: 'double',
        isRecordList: false,
      },
    ],
    language: 'JS',
    onProcessingStringified:
      '({ onProcessing(deltaTimeMs, inputs, state) {\n    const read = {\n      value(record) {\n        return record?.double ?? record?.float ?? record?.int32;\n      },\n      // What is no finite number counts as not there.\n      number(record, fallback, min, max) {\n        const value = this.value(record);\n        return Number.isFinite(value) ? Math.min(max, Math.max(min, value)) : fallback;\n      }\n    };\n    const waveHz = read.number(inputs.waveHz, 1, 0, 1e3);\n    const amplitude = read.number(inputs.amplitude, 1, -1e150, 1e150);\n    const offset = read.number(inputs.offset, 0, -1e150, 1e150);\n    const phase = read.number(inputs.phase, 0, -1e6, 1e6);\n    const dutyCycle = read.number(inputs.dutyCycle, 0.5, 0, 1);\n    const isFirst = state.runs === 0;\n    state.elapsedMs += deltaTimeMs;\n    const turns = state.turns + waveHz * deltaTimeMs / 1e3;\n    const tick = isFirst || turns >= 1;\n    state.turns = turns % 1;\n    const count = state.runs;\n    state.runs = (state.runs + 1) % 2 ** 31;\n    const at = ((state.turns + phase) % 1 + 1) % 1;\n    const wave = {\n      out(level) {\n        return { double: offset + amplitude * level };\n      }\n    };\n    return {\n      outputs: {\n        count: { int32: count },\n        elapsedMs: { double: state.elapsedMs },\n        tick: tick ? { bool: true } : void 0,\n        sine: wave.out(Math.sin(2 * Math.PI * at)),\n        square: wave.out(at < dutyCycle ? 1 : -1),\n        triangle: wave.out(at < 0.25 ? 4 * at : at < 0.75 ? 2 - 4 * at : 4 * at - 4),\n        saw: wave.out(2 * at - 1)\n      }\n    };\n  } })["onProcessing"]',
    onCreatedStringified:
      '(state) => { Object.assign(state, (() => ({ runs: 0, elapsedMs: 0, turns: 0 })\n)()); }',
    extension: {
      version: '1.0.0',
      libraries: [],
      replaceable: false,
      origin: 'MODULE_ORIGIN_UNKNOWN',
      grantIds: [],
    },
  },
  {
    name: 'counter',
    authors: ['Ubi-Interact'],
    tags: ['event', 'number', 'counter'],
    description: 'Counts events: each true that arrives. Another true sets the counter to zero.',
    processingMode: {
      triggerOnInput: {
        minDelayMs: 0,
        allInputsNeedUpdate: false,
      },
    },
    inputs: [
      {
        internalName: 'event',
        messageFormat: 'bool',
        isRecordList: false,
      },
      {
        internalName: 'reset',
        messageFormat: 'bool',
        isRecordList: false,
      },
      {
        internalName: 'step',
        messageFormat: 'int32',
        isRecordList: false,
        defaultJson: '{"int32":1}',
      },
    ],
    outputs: [
      {
        internalName: 'count',
        messageFormat: 'int32',
        isRecordList: false,
      },
    ],
    language: 'JS',
    onProcessingStringified:
      '({ onProcessing(_deltaTimeMs, inputs, state) {\n    const step = inputs.step?.int32 ?? 1;\n    const isOn = inputs.event?.bool === true;\n    const triggers = state.inputTriggerNames ?? [];\n    const isEvent = triggers.length > 0 ? isOn && triggers.includes("event") : isOn && !state.wasOn;\n    state.wasOn = isOn;\n    const isReset = inputs.reset?.bool === true && (triggers.length === 0 || triggers.includes("reset"));\n    if (isReset) state.count = 0;\n    else if (isEvent) state.count = state.count + step | 0;\n    if (state.told === state.count) return void 0;\n    state.told = state.count;\n    return { outputs: { count: { int32: state.count } } };\n  } })["onProcessing"]',
    onCreatedStringified:
      '(state) => { Object.assign(state, (() => ({\n    count: 0,\n    told: void 0,\n    wasOn: false\n  })\n)()); }',
    extension: {
      version: '1.0.0',
      libraries: [],
      replaceable: false,
      origin: 'MODULE_ORIGIN_UNKNOWN',
      grantIds: [],
    },
  },
  {
    name: 'http-poller',
    authors: ['Ubi-Interact'],
    tags: ['source', 'http', 'json', 'rest', 'iot'],
    description: 'Asks a web service at intervals and puts out one value of its JSON answer.',
    processingMode: {
      frequency: {
        hertz: 10,
      },
    },
    inputs: [
      {
        internalName: 'url',
        messageFormat: 'string',
        isRecordList: false,
      },
      {
        internalName: 'path',
        messageFormat: 'string',
        isRecordList: false,
      },
      {
        internalName: 'intervalMs',
        messageFormat: 'double',
        isRecordList: false,
        defaultJson: '{"double":1000}',
      },
      {
        internalName: 'timeoutMs',
        messageFormat: 'double',
        isRecordList: false,
        defaultJson: '{"double":10000}',
      },
    ],
    outputs: [
      {
        internalName: 'number',
        messageFormat: 'double',
        isRecordList: false,
      },
      {
        internalName: 'text',
        messageFormat: 'string',
        isRecordList: false,
      },
      {
        internalName: 'status',
        messageFormat: 'int32',
        isRecordList: false,
      },
      {
        internalName: 'error',
        messageFormat: 'string',
        isRecordList: false,
      },
    ],
    language: 'JS',
    onProcessingStringified:
      '({ onProcessing(deltaTimeMs, inputs, state) {\n    const read = {\n      value(record) {\n        return record?.double ?? record?.float ?? record?.int32;\n      },\n      // What is no finite number counts as not there.\n      number(record, fallback, min, max) {\n        const value2 = this.value(record);\n        return Number.isFinite(value2) ? Math.min(max, Math.max(min, value2)) : fallback;\n      },\n      /** The value at the path in the answer, or what is wrong. */\n      answer(answer, path) {\n        if ("reason" in answer) return answer;\n        if (answer.status < 200 || answer.status > 299) {\n          return { reason: `The service answered with status ${answer.status}.` };\n        }\n        let value2;\n        try {\n          value2 = JSON.parse(answer.text);\n        } catch {\n          if (path === "") return { value: answer.text.trim() };\n          return { reason: `The answer is no JSON, so it has no "${path}".` };\n        }\n        const keys = path.replace(/\\[(\\d+)\\]/g, ".$1").split(".");\n        for (const key of keys) {\n          if (key === "" || key === "$") continue;\n          if (typeof value2 !== "object" || value2 === null || !Object.hasOwn(value2, key)) {\n            return { reason: `The answer has no "${path}": there is no "${key}".` };\n          }\n          value2 = value2[key];\n        }\n        return { value: value2 };\n      }\n    };\n    const intervalMs = read.number(inputs.intervalMs, 1e3, 100, 864e5);\n    const timeoutMs = read.number(inputs.timeoutMs, 1e4, 100, 6e5);\n    const url = inputs.url?.string.trim() ?? "";\n    state.nowMs += deltaTimeMs;\n    let result;\n    let status = 0;\n    if (state.request !== void 0 && state.request.url !== url) {\n      state.request = void 0;\n      state.dueMs = state.nowMs;\n    }\n    const request = state.request;\n    if (request?.answer !== void 0) {\n      state.request = void 0;\n      if ("status" in request.answer) status = request.answer.status;\n      result = read.answer(request.answer, inputs.path?.string.trim() ?? "");\n    } else if (request !== void 0 && state.nowMs - request.sinceMs >= timeoutMs) {\n      state.request = void 0;\n      result = { reason: `The service did not answer within ${timeoutMs} ms.` };\n    }\n    if (state.request === void 0 && url !== "" && state.nowMs >= state.dueMs) {\n      state.dueMs = Math.max(state.dueMs + intervalMs, state.nowMs + intervalMs / 2);\n      if (/^https?:\\/\\//i.test(url)) {\n        const next = {\n          url,\n          sinceMs: state.nowMs,\n          answer: void 0\n        };\n        const asked = state.modules.http.get(url);\n        state.request = next;\n        asked.then(\n          (answer) => {\n            next.answer = { status: answer.status, text: answer.text };\n          },\n          (error2) => {\n            const reason = error2?.message ?? error2;\n            next.answer = { reason: `The request failed: ${String(reason)}` };\n          }\n        );\n      } else {\n        result = { reason: `"${url}" is no address: it has to start with http:// or https://.` };\n      }\n    }\n    if (result === void 0) return void 0;\n    const error = "reason" in result ? result.reason : "";\n    const hasNewError = error !== state.error;\n    state.error = error;\n    const value = "value" in result ? result.value : void 0;\n    const isNumeric = typeof value === "number" || typeof value === "boolean" || typeof value === "string" && value.trim() !== "";\n    const number = isNumeric ? Number(value) : NaN;\n    return {\n      outputs: {\n        number: Number.isFinite(number) ? { double: number } : void 0,\n        text: "value" in result ? { string: typeof value === "string" ? value : JSON.stringify(value) } : void 0,\n        status: status > 0 ? { int32: status } : void 0,\n        error: hasNewError ? { string: error } : void 0\n      }\n    };\n  } })["onProcessing"]',
    onCreatedStringified:
      '(state) => { Object.assign(state, (() => ({ nowMs: 0, dueMs: 0, request: void 0, error: "" })\n)());\nreturn (({ onCreated(state) {\n    if (typeof state.modules.http?.get !== "function") {\n      throw new Error(\n        \'This node does not offer the library "http": its operator has to allow origins with --allow-fetch.\'\n      );\n    }\n  } })["onCreated"]\n)(state); }',
    extension: {
      version: '1.0.0',
      libraries: ['http'],
      replaceable: false,
      origin: 'MODULE_ORIGIN_UNKNOWN',
      grantIds: [],
    },
  },
  {
    name: 'key-chord',
    authors: ['Ubi-Interact'],
    tags: ['event', 'key', 'keyboard', 'text'],
    description: 'Gives the keys that are held together as one text, such as "a + d".',
    processingMode: {
      triggerOnInput: {
        minDelayMs: 0,
        allInputsNeedUpdate: false,
      },
    },
    inputs: [
      {
        internalName: 'key',
        messageFormat: 'ubii.dataStructure.KeyEvent',
        isRecordList: false,
      },
    ],
    outputs: [
      {
        internalName: 'chord',
        messageFormat: 'string',
        isRecordList: false,
      },
      {
        internalName: 'count',
        messageFormat: 'int32',
        isRecordList: false,
      },
    ],
    language: 'JS',
    onProcessingStringified:
      '({ onProcessing(_deltaTimeMs, inputs, state) {\n    const event = inputs.key?.keyEvent;\n    if (event === void 0) return void 0;\n    const key = event.key === " " ? "Space" : event.key.slice(0, 32);\n    const others = state.held.filter((held) => held !== key);\n    const isDown = Number(event.type) === 1;\n    if (isDown && key !== "") {\n      if (others.length === state.held.length && others.length < 16) state.held.push(key);\n    } else state.held = others;\n    const chord = state.held.join(" + ");\n    if (chord === state.told) return void 0;\n    state.told = chord;\n    return { outputs: { chord: { string: chord }, count: { int32: state.held.length } } };\n  } })["onProcessing"]',
    onCreatedStringified:
      '(state) => { Object.assign(state, (() => ({ held: [], told: void 0 })\n)()); }',
    extension: {
      version: '1.0.0',
      libraries: [],
      replaceable: false,
      origin: 'MODULE_ORIGIN_UNKNOWN',
      grantIds: [],
    },
  },
  {
    name: 'load-generator',
    authors: ['Ubi-Interact'],
    tags: ['load', 'benchmark', 'performance'],
    description:
      'Adds up Fibonacci numbers for a chosen number of steps and tells how long it took.',
    processingMode: {
      frequency: {
        hertz: 30,
      },
    },
    inputs: [
      {
        internalName: 'iterations',
        messageFormat: 'int32',
        isRecordList: false,
        defaultJson: '{"int32":1000}',
      },
      {
        internalName: 'stamp',
        messageFormat: 'double',
        isRecordList: false,
      },
    ],
    outputs: [
      {
        internalName: 'result',
        messageFormat: 'double',
        isRecordList: false,
      },
      {
        internalName: 'durationMs',
        messageFormat: 'double',
        isRecordList: false,
      },
      {
        internalName: 'runs',
        messageFormat: 'int32',
        isRecordList: false,
      },
      {
        internalName: 'echo',
        messageFormat: 'double',
        isRecordList: false,
      },
    ],
    language: 'JS',
    onProcessingStringified:
      '({ onProcessing(_deltaTimeMs, inputs, state) {\n    const read = {\n      value(record) {\n        return record?.double ?? record?.float ?? record?.int32;\n      },\n      // Not every sandbox has a fine clock.\n      nowMs() {\n        return typeof performance === "object" ? performance.now() : Date.now();\n      }\n    };\n    const wanted = read.value(inputs.iterations) ?? 1e3;\n    const iterations = Number.isFinite(wanted) ? Math.min(1e7, Math.max(0, wanted)) : 1e3;\n    const startedMs = read.nowMs();\n    let previous = 0;\n    let current = 1;\n    for (let step = 0; step < iterations; step++) {\n      const next = previous + current >>> 0;\n      previous = current;\n      current = next;\n    }\n    const durationMs = read.nowMs() - startedMs;\n    state.runs = (state.runs + 1) % 2 ** 31;\n    const stamp = read.value(inputs.stamp);\n    return {\n      outputs: {\n        result: { double: previous },\n        durationMs: { double: Math.max(0, durationMs) },\n        runs: { int32: state.runs },\n        echo: Number.isFinite(stamp) ? { double: stamp, timestamp: inputs.stamp?.timestamp } : void 0\n      }\n    };\n  } })["onProcessing"]',
    onCreatedStringified: '(state) => { Object.assign(state, (() => ({ runs: 0 })\n)()); }',
    extension: {
      version: '1.0.0',
      libraries: [],
      replaceable: false,
      origin: 'MODULE_ORIGIN_UNKNOWN',
      grantIds: [],
    },
  },
  {
    name: 'low-pass',
    authors: ['Ubi-Interact'],
    tags: ['filter', 'smoothing', 'low-pass'],
    description:
      'Smooths a double with a first-order low-pass; right for any interval between records.',
    processingMode: {
      triggerOnInput: {
        minDelayMs: 0,
        allInputsNeedUpdate: false,
      },
    },
    inputs: [
      {
        internalName: 'value',
        messageFormat: 'double',
        isRecordList: false,
      },
      {
        internalName: 'cutoffHz',
        messageFormat: 'double',
        isRecordList: false,
        defaultJson: '{"double":1}',
      },
    ],
    outputs: [
      {
        internalName: 'smoothed',
        messageFormat: 'double',
        isRecordList: false,
      },
    ],
    language: 'JS',
    onProcessingStringified:
      'function smooth(deltaTimeMs, inputs, state) {\n  const read = {\n    value(record2) {\n      return record2?.double ?? record2?.float ?? record2?.int32;\n    },\n    // What is no finite number counts as not there.\n    number(record2, fallback, min, max) {\n      const value2 = this.value(record2);\n      return Number.isFinite(value2) ? Math.min(max, Math.max(min, value2)) : fallback;\n    }\n  };\n  const cutoffHz = read.number(inputs.cutoffHz, 1, 0, 1e3);\n  state.waitedMs += deltaTimeMs;\n  const record = inputs.value;\n  const triggers = state.inputTriggerNames ?? [];\n  if (record === void 0 || triggers.length > 0 && !triggers.includes("value"))\n    return void 0;\n  const value = record[record.type];\n  const names = typeof value === "number" ? [] : ["x", "y", "z", "w"].filter((name) => name in value);\n  let parts = typeof value === "number" ? [value] : names.map((name) => value[name]);\n  const isRotation = record.type === "quaternion";\n  if (isRotation) {\n    const length = Math.hypot(...parts);\n    parts = parts.map((part) => part / length);\n  }\n  if (!parts.every((part) => Math.abs(part) <= 1e150)) return void 0;\n  let smoothed = state.smoothed;\n  if (smoothed === void 0 || smoothed.length !== parts.length) {\n    smoothed = parts;\n  } else {\n    const before = smoothed;\n    const sign = isRotation && before.reduce((sum, b, i) => sum + b * parts[i], 0) < 0 ? -1 : 1;\n    const share = -Math.expm1(-2 * Math.PI * cutoffHz * state.waitedMs / 1e3);\n    smoothed = before.map((b, i) => {\n      const p = sign * parts[i];\n      return share < 0.5 ? b + share * (p - b) : p - (1 - share) * (p - b);\n    });\n    if (isRotation) {\n      const length = Math.hypot(...smoothed);\n      smoothed = smoothed.map((part) => part / length);\n    }\n  }\n  state.smoothed = smoothed;\n  state.waitedMs = 0;\n  if (typeof value === "number") return { outputs: { smoothed: { double: smoothed[0] } } };\n  const members = Object.fromEntries(names.map((name, i) => [name, smoothed[i]]));\n  return { outputs: { smoothed: { [record.type]: members } } };\n}',
    onCreatedStringified:
      '(state) => { Object.assign(state, (() => ({ smoothed: void 0, waitedMs: 0 })\n)()); }',
    extension: {
      version: '1.0.0',
      libraries: [],
      replaceable: false,
      origin: 'MODULE_ORIGIN_UNKNOWN',
      grantIds: [],
    },
  },
  {
    name: 'low-pass-quaternion',
    authors: ['Ubi-Interact'],
    tags: ['filter', 'smoothing', 'low-pass'],
    description:
      'Smooths a quaternion with a first-order low-pass; right for any interval between records.',
    processingMode: {
      triggerOnInput: {
        minDelayMs: 0,
        allInputsNeedUpdate: false,
      },
    },
    inputs: [
      {
        internalName: 'value',
        messageFormat: 'ubii.dataStructure.Quaternion',
        isRecordList: false,
      },
      {
        internalName: 'cutoffHz',
        messageFormat: 'double',
        isRecordList: false,
        defaultJson: '{"double":1}',
      },
    ],
    outputs: [
      {
        internalName: 'smoothed',
        messageFormat: 'ubii.dataStructure.Quaternion',
        isRecordList: false,
      },
    ],
    language: 'JS',
    onProcessingStringified:
      'function smooth(deltaTimeMs, inputs, state) {\n  const read = {\n    value(record2) {\n      return record2?.double ?? record2?.float ?? record2?.int32;\n    },\n    // What is no finite number counts as not there.\n    number(record2, fallback, min, max) {\n      const value2 = this.value(record2);\n      return Number.isFinite(value2) ? Math.min(max, Math.max(min, value2)) : fallback;\n    }\n  };\n  const cutoffHz = read.number(inputs.cutoffHz, 1, 0, 1e3);\n  state.waitedMs += deltaTimeMs;\n  const record = inputs.value;\n  const triggers = state.inputTriggerNames ?? [];\n  if (record === void 0 || triggers.length > 0 && !triggers.includes("value"))\n    return void 0;\n  const value = record[record.type];\n  const names = typeof value === "number" ? [] : ["x", "y", "z", "w"].filter((name) => name in value);\n  let parts = typeof value === "number" ? [value] : names.map((name) => value[name]);\n  const isRotation = record.type === "quaternion";\n  if (isRotation) {\n    const length = Math.hypot(...parts);\n    parts = parts.map((part) => part / length);\n  }\n  if (!parts.every((part) => Math.abs(part) <= 1e150)) return void 0;\n  let smoothed = state.smoothed;\n  if (smoothed === void 0 || smoothed.length !== parts.length) {\n    smoothed = parts;\n  } else {\n    const before = smoothed;\n    const sign = isRotation && before.reduce((sum, b, i) => sum + b * parts[i], 0) < 0 ? -1 : 1;\n    const share = -Math.expm1(-2 * Math.PI * cutoffHz * state.waitedMs / 1e3);\n    smoothed = before.map((b, i) => {\n      const p = sign * parts[i];\n      return share < 0.5 ? b + share * (p - b) : p - (1 - share) * (p - b);\n    });\n    if (isRotation) {\n      const length = Math.hypot(...smoothed);\n      smoothed = smoothed.map((part) => part / length);\n    }\n  }\n  state.smoothed = smoothed;\n  state.waitedMs = 0;\n  if (typeof value === "number") return { outputs: { smoothed: { double: smoothed[0] } } };\n  const members = Object.fromEntries(names.map((name, i) => [name, smoothed[i]]));\n  return { outputs: { smoothed: { [record.type]: members } } };\n}',
    onCreatedStringified:
      '(state) => { Object.assign(state, (() => ({ smoothed: void 0, waitedMs: 0 })\n)()); }',
    extension: {
      version: '1.0.0',
      libraries: [],
      replaceable: false,
      origin: 'MODULE_ORIGIN_UNKNOWN',
      grantIds: [],
    },
  },
  {
    name: 'low-pass-vector2',
    authors: ['Ubi-Interact'],
    tags: ['filter', 'smoothing', 'low-pass'],
    description:
      'Smooths a vector2 with a first-order low-pass; right for any interval between records.',
    processingMode: {
      triggerOnInput: {
        minDelayMs: 0,
        allInputsNeedUpdate: false,
      },
    },
    inputs: [
      {
        internalName: 'value',
        messageFormat: 'ubii.dataStructure.Vector2',
        isRecordList: false,
      },
      {
        internalName: 'cutoffHz',
        messageFormat: 'double',
        isRecordList: false,
        defaultJson: '{"double":1}',
      },
    ],
    outputs: [
      {
        internalName: 'smoothed',
        messageFormat: 'ubii.dataStructure.Vector2',
        isRecordList: false,
      },
    ],
    language: 'JS',
    onProcessingStringified:
      'function smooth(deltaTimeMs, inputs, state) {\n  const read = {\n    value(record2) {\n      return record2?.double ?? record2?.float ?? record2?.int32;\n    },\n    // What is no finite number counts as not there.\n    number(record2, fallback, min, max) {\n      const value2 = this.value(record2);\n      return Number.isFinite(value2) ? Math.min(max, Math.max(min, value2)) : fallback;\n    }\n  };\n  const cutoffHz = read.number(inputs.cutoffHz, 1, 0, 1e3);\n  state.waitedMs += deltaTimeMs;\n  const record = inputs.value;\n  const triggers = state.inputTriggerNames ?? [];\n  if (record === void 0 || triggers.length > 0 && !triggers.includes("value"))\n    return void 0;\n  const value = record[record.type];\n  const names = typeof value === "number" ? [] : ["x", "y", "z", "w"].filter((name) => name in value);\n  let parts = typeof value === "number" ? [value] : names.map((name) => value[name]);\n  const isRotation = record.type === "quaternion";\n  if (isRotation) {\n    const length = Math.hypot(...parts);\n    parts = parts.map((part) => part / length);\n  }\n  if (!parts.every((part) => Math.abs(part) <= 1e150)) return void 0;\n  let smoothed = state.smoothed;\n  if (smoothed === void 0 || smoothed.length !== parts.length) {\n    smoothed = parts;\n  } else {\n    const before = smoothed;\n    const sign = isRotation && before.reduce((sum, b, i) => sum + b * parts[i], 0) < 0 ? -1 : 1;\n    const share = -Math.expm1(-2 * Math.PI * cutoffHz * state.waitedMs / 1e3);\n    smoothed = before.map((b, i) => {\n      const p = sign * parts[i];\n      return share < 0.5 ? b + share * (p - b) : p - (1 - share) * (p - b);\n    });\n    if (isRotation) {\n      const length = Math.hypot(...smoothed);\n      smoothed = smoothed.map((part) => part / length);\n    }\n  }\n  state.smoothed = smoothed;\n  state.waitedMs = 0;\n  if (typeof value === "number") return { outputs: { smoothed: { double: smoothed[0] } } };\n  const members = Object.fromEntries(names.map((name, i) => [name, smoothed[i]]));\n  return { outputs: { smoothed: { [record.type]: members } } };\n}',
    onCreatedStringified:
      '(state) => { Object.assign(state, (() => ({ smoothed: void 0, waitedMs: 0 })\n)()); }',
    extension: {
      version: '1.0.0',
      libraries: [],
      replaceable: false,
      origin: 'MODULE_ORIGIN_UNKNOWN',
      grantIds: [],
    },
  },
  {
    name: 'low-pass-vector3',
    authors: ['Ubi-Interact'],
    tags: ['filter', 'smoothing', 'low-pass'],
    description:
      'Smooths a vector3 with a first-order low-pass; right for any interval between records.',
    processingMode: {
      triggerOnInput: {
        minDelayMs: 0,
        allInputsNeedUpdate: false,
      },
    },
    inputs: [
      {
        internalName: 'value',
        messageFormat: 'ubii.dataStructure.Vector3',
        isRecordList: false,
      },
      {
        internalName: 'cutoffHz',
        messageFormat: 'double',
        isRecordList: false,
        defaultJson: '{"double":1}',
      },
    ],
    outputs: [
      {
        internalName: 'smoothed',
        messageFormat: 'ubii.dataStructure.Vector3',
        isRecordList: false,
      },
    ],
    language: 'JS',
    onProcessingStringified:
      'function smooth(deltaTimeMs, inputs, state) {\n  const read = {\n    value(record2) {\n      return record2?.double ?? record2?.float ?? record2?.int32;\n    },\n    // What is no finite number counts as not there.\n    number(record2, fallback, min, max) {\n      const value2 = this.value(record2);\n      return Number.isFinite(value2) ? Math.min(max, Math.max(min, value2)) : fallback;\n    }\n  };\n  const cutoffHz = read.number(inputs.cutoffHz, 1, 0, 1e3);\n  state.waitedMs += deltaTimeMs;\n  const record = inputs.value;\n  const triggers = state.inputTriggerNames ?? [];\n  if (record === void 0 || triggers.length > 0 && !triggers.includes("value"))\n    return void 0;\n  const value = record[record.type];\n  const names = typeof value === "number" ? [] : ["x", "y", "z", "w"].filter((name) => name in value);\n  let parts = typeof value === "number" ? [value] : names.map((name) => value[name]);\n  const isRotation = record.type === "quaternion";\n  if (isRotation) {\n    const length = Math.hypot(...parts);\n    parts = parts.map((part) => part / length);\n  }\n  if (!parts.every((part) => Math.abs(part) <= 1e150)) return void 0;\n  let smoothed = state.smoothed;\n  if (smoothed === void 0 || smoothed.length !== parts.length) {\n    smoothed = parts;\n  } else {\n    const before = smoothed;\n    const sign = isRotation && before.reduce((sum, b, i) => sum + b * parts[i], 0) < 0 ? -1 : 1;\n    const share = -Math.expm1(-2 * Math.PI * cutoffHz * state.waitedMs / 1e3);\n    smoothed = before.map((b, i) => {\n      const p = sign * parts[i];\n      return share < 0.5 ? b + share * (p - b) : p - (1 - share) * (p - b);\n    });\n    if (isRotation) {\n      const length = Math.hypot(...smoothed);\n      smoothed = smoothed.map((part) => part / length);\n    }\n  }\n  state.smoothed = smoothed;\n  state.waitedMs = 0;\n  if (typeof value === "number") return { outputs: { smoothed: { double: smoothed[0] } } };\n  const members = Object.fromEntries(names.map((name, i) => [name, smoothed[i]]));\n  return { outputs: { smoothed: { [record.type]: members } } };\n}',
    onCreatedStringified:
      '(state) => { Object.assign(state, (() => ({ smoothed: void 0, waitedMs: 0 })\n)()); }',
    extension: {
      version: '1.0.0',
      libraries: [],
      replaceable: false,
      origin: 'MODULE_ORIGIN_UNKNOWN',
      grantIds: [],
    },
  },
  {
    name: 'low-pass-vector4',
    authors: ['Ubi-Interact'],
    tags: ['filter', 'smoothing', 'low-pass'],
    description:
      'Smooths a vector4 with a first-order low-pass; right for any interval between records.',
    processingMode: {
      triggerOnInput: {
        minDelayMs: 0,
        allInputsNeedUpdate: false,
      },
    },
    inputs: [
      {
        internalName: 'value',
        messageFormat: 'ubii.dataStructure.Vector4',
        isRecordList: false,
      },
      {
        internalName: 'cutoffHz',
        messageFormat: 'double',
        isRecordList: false,
        defaultJson: '{"double":1}',
      },
    ],
    outputs: [
      {
        internalName: 'smoothed',
        messageFormat: 'ubii.dataStructure.Vector4',
        isRecordList: false,
      },
    ],
    language: 'JS',
    onProcessingStringified:
      'function smooth(deltaTimeMs, inputs, state) {\n  const read = {\n    value(record2) {\n      return record2?.double ?? record2?.float ?? record2?.int32;\n    },\n    // What is no finite number counts as not there.\n    number(record2, fallback, min, max) {\n      const value2 = this.value(record2);\n      return Number.isFinite(value2) ? Math.min(max, Math.max(min, value2)) : fallback;\n    }\n  };\n  const cutoffHz = read.number(inputs.cutoffHz, 1, 0, 1e3);\n  state.waitedMs += deltaTimeMs;\n  const record = inputs.value;\n  const triggers = state.inputTriggerNames ?? [];\n  if (record === void 0 || triggers.length > 0 && !triggers.includes("value"))\n    return void 0;\n  const value = record[record.type];\n  const names = typeof value === "number" ? [] : ["x", "y", "z", "w"].filter((name) => name in value);\n  let parts = typeof value === "number" ? [value] : names.map((name) => value[name]);\n  const isRotation = record.type === "quaternion";\n  if (isRotation) {\n    const length = Math.hypot(...parts);\n    parts = parts.map((part) => part / length);\n  }\n  if (!parts.every((part) => Math.abs(part) <= 1e150)) return void 0;\n  let smoothed = state.smoothed;\n  if (smoothed === void 0 || smoothed.length !== parts.length) {\n    smoothed = parts;\n  } else {\n    const before = smoothed;\n    const sign = isRotation && before.reduce((sum, b, i) => sum + b * parts[i], 0) < 0 ? -1 : 1;\n    const share = -Math.expm1(-2 * Math.PI * cutoffHz * state.waitedMs / 1e3);\n    smoothed = before.map((b, i) => {\n      const p = sign * parts[i];\n      return share < 0.5 ? b + share * (p - b) : p - (1 - share) * (p - b);\n    });\n    if (isRotation) {\n      const length = Math.hypot(...smoothed);\n      smoothed = smoothed.map((part) => part / length);\n    }\n  }\n  state.smoothed = smoothed;\n  state.waitedMs = 0;\n  if (typeof value === "number") return { outputs: { smoothed: { double: smoothed[0] } } };\n  const members = Object.fromEntries(names.map((name, i) => [name, smoothed[i]]));\n  return { outputs: { smoothed: { [record.type]: members } } };\n}',
    onCreatedStringified:
      '(state) => { Object.assign(state, (() => ({ smoothed: void 0, waitedMs: 0 })\n)()); }',
    extension: {
      version: '1.0.0',
      libraries: [],
      replaceable: false,
      origin: 'MODULE_ORIGIN_UNKNOWN',
      grantIds: [],
    },
  },
  {
    name: 'map-range',
    authors: ['Ubi-Interact'],
    tags: ['number', 'scale', 'clamp'],
    description: 'Maps a number from one range to another, with clamping, inversion and a curve.',
    processingMode: {
      triggerOnInput: {
        minDelayMs: 0,
        allInputsNeedUpdate: false,
      },
    },
    inputs: [
      {
        internalName: 'value',
        messageFormat: 'double',
        isRecordList: false,
      },
      {
        internalName: 'inMin',
        messageFormat: 'double',
        isRecordList: false,
        defaultJson: '{"double":0}',
      },
      {
        internalName: 'inMax',
        messageFormat: 'double',
        isRecordList: false,
        defaultJson: '{"double":1}',
      },
      {
        internalName: 'outMin',
        messageFormat: 'double',
        isRecordList: false,
        defaultJson: '{"double":0}',
      },
      {
        internalName: 'outMax',
        messageFormat: 'double',
        isRecordList: false,
        defaultJson: '{"double":1}',
      },
      {
        internalName: 'clamp',
        messageFormat: 'bool',
        isRecordList: false,
        defaultJson: '{"bool":true}',
      },
      {
        internalName: 'invert',
        messageFormat: 'bool',
        isRecordList: false,
        defaultJson: '{"bool":false}',
      },
      {
        internalName: 'exponent',
        messageFormat: 'double',
        isRecordList: false,
        defaultJson: '{"double":1}',
      },
    ],
    outputs: [
      {
        internalName: 'mapped',
        messageFormat: 'double',
        isRecordList: false,
      },
    ],
    language: 'JS',
    onProcessingStringified:
      '({ onProcessing(_deltaTimeMs, inputs) {\n    const read = {\n      value(record) {\n        return record?.double ?? record?.float ?? record?.int32;\n      },\n      // What is no finite number counts as not there.\n      number(record, fallback, min, max) {\n        const value2 = this.value(record);\n        return Number.isFinite(value2) ? Math.min(max, Math.max(min, value2)) : fallback;\n      }\n    };\n    const value = read.value(inputs.value);\n    if (value === void 0 || Number.isNaN(value)) return void 0;\n    const inMin = read.number(inputs.inMin, 0, -1e150, 1e150);\n    const inMax = read.number(inputs.inMax, 1, -1e150, 1e150);\n    const outMin = read.number(inputs.outMin, 0, -1e150, 1e150);\n    const outMax = read.number(inputs.outMax, 1, -1e150, 1e150);\n    const exponent = read.number(inputs.exponent, 1, 0.01, 100);\n    let share = inMin === inMax ? value < inMin ? 0 : 1 : (value - inMin) / (inMax - inMin);\n    if (inputs.clamp?.bool ?? true) share = Math.min(1, Math.max(0, share));\n    if (exponent !== 1) share = Math.sign(share) * Math.abs(share) ** exponent;\n    if (inputs.invert?.bool) share = 1 - share;\n    const range = outMax - outMin;\n    const mapped = share < 0.5 ? outMin + range * share : outMax - range * (1 - share);\n    return Number.isFinite(mapped) ? { outputs: { mapped: { double: mapped } } } : void 0;\n  } })["onProcessing"]',
    extension: {
      version: '1.0.0',
      libraries: [],
      replaceable: false,
      origin: 'MODULE_ORIGIN_UNKNOWN',
      grantIds: [],
    },
  },
  {
    name: 'merge-vector2',
    authors: ['Ubi-Interact'],
    tags: ['vector', 'number', 'merge'],
    description: 'Merges two numbers into a vector.',
    processingMode: {
      triggerOnInput: {
        minDelayMs: 0,
        allInputsNeedUpdate: false,
      },
    },
    inputs: [
      {
        internalName: 'x',
        messageFormat: 'double',
        isRecordList: false,
      },
      {
        internalName: 'y',
        messageFormat: 'double',
        isRecordList: false,
      },
    ],
    outputs: [
      {
        internalName: 'vector',
        messageFormat: 'ubii.dataStructure.Vector2',
        isRecordList: false,
      },
    ],
    language: 'JS',
    onProcessingStringified:
      '({ onProcessing(_deltaTimeMs, inputs) {\n    if (!inputs.x && !inputs.y) return void 0;\n    const [x = 0, y = 0] = [inputs.x, inputs.y].map(\n      (record) => record?.double ?? record?.float ?? record?.int32\n    );\n    if (![x, y].every(Number.isFinite)) return void 0;\n    return { outputs: { vector: { vector2: { x, y } } } };\n  } })["onProcessing"]',
    extension: {
      version: '1.0.0',
      libraries: [],
      replaceable: false,
      origin: 'MODULE_ORIGIN_UNKNOWN',
      grantIds: [],
    },
  },
  {
    name: 'merge-vector3',
    authors: ['Ubi-Interact'],
    tags: ['vector', 'number', 'merge'],
    description: 'Merges three numbers into a vector.',
    processingMode: {
      triggerOnInput: {
        minDelayMs: 0,
        allInputsNeedUpdate: false,
      },
    },
    inputs: [
      {
        internalName: 'x',
        messageFormat: 'double',
        isRecordList: false,
      },
      {
        internalName: 'y',
        messageFormat: 'double',
        isRecordList: false,
      },
      {
        internalName: 'z',
        messageFormat: 'double',
        isRecordList: false,
      },
    ],
    outputs: [
      {
        internalName: 'vector',
        messageFormat: 'ubii.dataStructure.Vector3',
        isRecordList: false,
      },
    ],
    language: 'JS',
    onProcessingStringified:
      '({ onProcessing(_deltaTimeMs, inputs) {\n    if (!inputs.x && !inputs.y && !inputs.z) return void 0;\n    const [x = 0, y = 0, z = 0] = [inputs.x, inputs.y, inputs.z].map(\n      (record) => record?.double ?? record?.float ?? record?.int32\n    );\n    if (![x, y, z].every(Number.isFinite)) return void 0;\n    return { outputs: { vector: { vector3: { x, y, z } } } };\n  } })["onProcessing"]',
    extension: {
      version: '1.0.0',
      libraries: [],
      replaceable: false,
      origin: 'MODULE_ORIGIN_UNKNOWN',
      grantIds: [],
    },
  },
  {
    name: 'merge-vector4',
    authors: ['Ubi-Interact'],
    tags: ['vector', 'number', 'merge'],
    description: 'Merges four numbers into a vector.',
    processingMode: {
      triggerOnInput: {
        minDelayMs: 0,
        allInputsNeedUpdate: false,
      },
    },
    inputs: [
      {
        internalName: 'x',
        messageFormat: 'double',
        isRecordList: false,
      },
      {
        internalName: 'y',
        messageFormat: 'double',
        isRecordList: false,
      },
      {
        internalName: 'z',
        messageFormat: 'double',
        isRecordList: false,
      },
      {
        internalName: 'w',
        messageFormat: 'double',
        isRecordList: false,
      },
    ],
    outputs: [
      {
        internalName: 'vector',
        messageFormat: 'ubii.dataStructure.Vector4',
        isRecordList: false,
      },
    ],
    language: 'JS',
    onProcessingStringified:
      '({ onProcessing(_deltaTimeMs, inputs) {\n    if (!inputs.x && !inputs.y && !inputs.z && !inputs.w) return void 0;\n    const [x = 0, y = 0, z = 0, w = 0] = [inputs.x, inputs.y, inputs.z, inputs.w].map(\n      (record) => record?.double ?? record?.float ?? record?.int32\n    );\n    if (![x, y, z, w].every(Number.isFinite)) return void 0;\n    return { outputs: { vector: { vector4: { x, y, z, w } } } };\n  } })["onProcessing"]',
    extension: {
      version: '1.0.0',
      libraries: [],
      replaceable: false,
      origin: 'MODULE_ORIGIN_UNKNOWN',
      grantIds: [],
    },
  },
  {
    name: 'mirror-pointer',
    authors: ['Ubi-Interact'],
    tags: ['pointer', 'vector', 'example'],
    description: 'Mirrors a position from 0 to 1 around the centre, in x, in y, or in both.',
    processingMode: {
      triggerOnInput: {
        minDelayMs: 0,
        allInputsNeedUpdate: false,
      },
    },
    inputs: [
      {
        internalName: 'pointer',
        messageFormat: 'ubii.dataStructure.Vector2',
        isRecordList: false,
      },
      {
        internalName: 'mirrorX',
        messageFormat: 'bool',
        isRecordList: false,
        defaultJson: '{"bool":false}',
      },
      {
        internalName: 'mirrorY',
        messageFormat: 'bool',
        isRecordList: false,
        defaultJson: '{"bool":false}',
      },
    ],
    outputs: [
      {
        internalName: 'mirrored',
        messageFormat: 'ubii.dataStructure.Vector2',
        isRecordList: false,
      },
    ],
    language: 'JS',
    onProcessingStringified:
      '({ onProcessing(_deltaTimeMs, inputs, state) {\n    const pointer = inputs.pointer;\n    if (pointer === void 0) return void 0;\n    const { x, y } = pointer.vector2;\n    if (!Number.isFinite(x) || !Number.isFinite(y)) return void 0;\n    const vector2 = {\n      x: inputs.mirrorX?.bool ? 1 - x : x,\n      y: inputs.mirrorY?.bool ? 1 - y : y\n    };\n    const triggers = state.inputTriggerNames ?? [];\n    const isNew = triggers.length === 0 || triggers.includes("pointer");\n    return {\n      outputs: {\n        mirrored: isNew && pointer.timestamp ? { vector2, timestamp: pointer.timestamp } : { vector2 }\n      }\n    };\n  } })["onProcessing"]',
    extension: {
      version: '1.0.0',
      libraries: [],
      replaceable: false,
      origin: 'MODULE_ORIGIN_UNKNOWN',
      grantIds: [],
    },
  },
  {
    name: 'mix',
    authors: ['Ubi-Interact'],
    tags: ['number', 'sum', 'mixer'],
    description: 'Adds up to three numbers, each multiplied by a gain. A negative gain subtracts.',
    processingMode: {
      triggerOnInput: {
        minDelayMs: 0,
        allInputsNeedUpdate: false,
      },
    },
    inputs: [
      {
        internalName: 'a',
        messageFormat: 'double',
        isRecordList: false,
      },
      {
        internalName: 'b',
        messageFormat: 'double',
        isRecordList: false,
      },
      {
        internalName: 'c',
        messageFormat: 'double',
        isRecordList: false,
      },
      {
        internalName: 'gainA',
        messageFormat: 'double',
        isRecordList: false,
        defaultJson: '{"double":1}',
      },
      {
        internalName: 'gainB',
        messageFormat: 'double',
        isRecordList: false,
        defaultJson: '{"double":1}',
      },
      {
        internalName: 'gainC',
        messageFormat: 'double',
        isRecordList: false,
        defaultJson: '{"double":1}',
      },
    ],
    outputs: [
      {
        internalName: 'mixed',
        messageFormat: 'double',
        isRecordList: false,
      },
    ],
    language: 'JS',
    onProcessingStringified:
      '({ onProcessing(_deltaTimeMs, inputs) {\n    const read = {\n      value(record) {\n        return record?.double ?? record?.float ?? record?.int32;\n      },\n      // What is not a finite number counts as missing.\n      number(record, fallback) {\n        const value = this.value(record);\n        return Number.isFinite(value) ? value : fallback;\n      }\n    };\n    if (!inputs.a && !inputs.b && !inputs.c) return void 0;\n    const mixed = read.number(inputs.a, 0) * read.number(inputs.gainA, 1) + read.number(inputs.b, 0) * read.number(inputs.gainB, 1) + read.number(inputs.c, 0) * read.number(inputs.gainC, 1);\n    return Number.isFinite(mixed) ? { outputs: { mixed: { double: mixed } } } : void 0;\n  } })["onProcessing"]',
    extension: {
      version: '1.0.0',
      libraries: [],
      replaceable: false,
      origin: 'MODULE_ORIGIN_UNKNOWN',
      grantIds: [],
    },
  },
  {
    name: 'noise',
    authors: ['Ubi-Interact'],
    tags: ['source', 'generator', 'number', 'random'],
    description:
      'Gives pseudo-random numbers: uniform, normal, and a random walk that stays in range.',
    processingMode: {
      frequency: {
        hertz: 30,
      },
    },
    inputs: [
      {
        internalName: 'amplitude',
        messageFormat: 'double',
        isRecordList: false,
        defaultJson: '{"double":1}',
      },
      {
        internalName: 'offset',
        messageFormat: 'double',
        isRecordList: false,
        defaultJson: '{"double":0}',
      },
      {
        internalName: 'walkSpeed',
        messageFormat: 'double',
        isRecordList: false,
        defaultJson: '{"double":1}',
      },
      {
        internalName: 'seed',
        messageFormat: 'int32',
        isRecordList: false,
        defaultJson: '{"int32":1}',
      },
    ],
    outputs: [
      {
        internalName: 'uniform',
        messageFormat: 'double',
        isRecordList: false,
      },
      {
        internalName: 'normal',
        messageFormat: 'double',
        isRecordList: false,
      },
      {
        internalName: 'walk',
        messageFormat: 'double',
        isRecordList: false,
      },
    ],
    language: 'JS',
    onProcessingStringified:
      '({ onProcessing(deltaTimeMs, inputs, state) {\n    const read = {\n      value(record) {\n        return record?.double ?? record?.float ?? record?.int32;\n      },\n      // What is not a finite number counts as missing.\n      number(record, fallback, min, max) {\n        const value = this.value(record);\n        return Number.isFinite(value) ? Math.min(max, Math.max(min, value)) : fallback;\n      },\n      /** From 0 to below 1. */\n      random() {\n        state.random = state.random + 1831565813 | 0;\n        let mixed = Math.imul(state.random ^ state.random >>> 15, 1 | state.random);\n        mixed = mixed + Math.imul(mixed ^ mixed >>> 7, 61 | mixed) ^ mixed;\n        return ((mixed ^ mixed >>> 14) >>> 0) / 4294967296;\n      }\n    };\n    const amplitude = read.number(inputs.amplitude, 1, -1e150, 1e150);\n    const offset = read.number(inputs.offset, 0, -1e150, 1e150);\n    const walkSpeed = read.number(inputs.walkSpeed, 1, 0, 100);\n    const seed = read.number(inputs.seed, 1, -(2 ** 31), 2 ** 31 - 1) | 0;\n    if (state.seed !== seed) {\n      state.seed = seed;\n      state.random = seed;\n      state.walk = 0;\n    }\n    const uniform = 2 * read.random() - 1;\n    const radius = Math.sqrt(-2 * Math.log(1 - read.random()));\n    const normal = radius * Math.cos(2 * Math.PI * read.random());\n    const seconds = Math.min(1, deltaTimeMs / 1e3);\n    let walk = state.walk + normal * walkSpeed * Math.sqrt(seconds);\n    walk = ((walk + 1) % 4 + 4) % 4 - 1;\n    if (walk > 1) walk = 2 - walk;\n    state.walk = walk;\n    return {\n      outputs: {\n        uniform: { double: offset + amplitude * uniform },\n        normal: { double: offset + amplitude * normal },\n        walk: { double: offset + amplitude * walk }\n      }\n    };\n  } })["onProcessing"]',
    onCreatedStringified:
      '(state) => { Object.assign(state, (() => ({\n    seed: void 0,\n    random: 0,\n    walk: 0\n  })\n)()); }',
    extension: {
      version: '1.0.0',
      libraries: [],
      replaceable: false,
      origin: 'MODULE_ORIGIN_UNKNOWN',
      grantIds: [],
    },
  },
  {
    name: 'one-euro-filter',
    authors: ['Ubi-Interact'],
    tags: ['filter', 'smoothing', 'one-euro'],
    description:
      'Smooths a double: strongly while it is slow, hardly while it is fast (1€ filter).',
    processingMode: {
      triggerOnInput: {
        minDelayMs: 0,
        allInputsNeedUpdate: false,
      },
    },
    inputs: [
      {
        internalName: 'value',
        messageFormat: 'double',
        isRecordList: false,
      },
      {
        internalName: 'minCutoffHz',
        messageFormat: 'double',
        isRecordList: false,
        defaultJson: '{"double":1}',
      },
      {
        internalName: 'beta',
        messageFormat: 'double',
        isRecordList: false,
        defaultJson: '{"double":1}',
      },
      {
        internalName: 'derivativeCutoffHz',
        messageFormat: 'double',
        isRecordList: false,
        defaultJson: '{"double":1}',
      },
    ],
    outputs: [
      {
        internalName: 'smoothed',
        messageFormat: 'double',
        isRecordList: false,
      },
    ],
    language: 'JS',
    onProcessingStringified:
      'function smooth2(deltaTimeMs, inputs, state) {\n  const read = {\n    value(record2) {\n      return record2?.double ?? record2?.float ?? record2?.int32;\n    },\n    // What is no finite number counts as not there.\n    number(record2, fallback, min, max) {\n      const value2 = this.value(record2);\n      return Number.isFinite(value2) ? Math.min(max, Math.max(min, value2)) : fallback;\n    },\n    /** How far the smoothed value goes towards a new one: the paper\'s alpha. */\n    share(cutoffHz, seconds) {\n      const turns = 2 * Math.PI * cutoffHz * seconds;\n      return turns === Infinity ? 1 : turns / (turns + 1);\n    }\n  };\n  const minCutoffHz = read.number(inputs.minCutoffHz, 1, 0, 1e3);\n  const beta = read.number(inputs.beta, 1, 0, 1e9);\n  const derivativeCutoffHz = read.number(inputs.derivativeCutoffHz, 1, 0, 1e3);\n  state.waitedMs += deltaTimeMs;\n  const record = inputs.value;\n  const triggers = state.inputTriggerNames ?? [];\n  if (record === void 0 || triggers.length > 0 && !triggers.includes("value"))\n    return void 0;\n  const value = record[record.type];\n  const names = typeof value === "number" ? [] : ["x", "y", "z", "w"].filter((name) => name in value);\n  let parts = typeof value === "number" ? [value] : names.map((name) => value[name]);\n  const isRotation = record.type === "quaternion";\n  if (isRotation) {\n    const length = Math.hypot(...parts);\n    parts = parts.map((part) => part / length);\n  }\n  if (!parts.every((part) => Math.abs(part) <= 1e150)) return void 0;\n  let smoothed = state.smoothed;\n  if (smoothed === void 0 || smoothed.length !== parts.length) {\n    smoothed = parts;\n    state.speed = parts.map(() => 0);\n  } else if (state.waitedMs > 0) {\n    const before = smoothed;\n    const seconds = state.waitedMs / 1e3;\n    const sign = isRotation && before.reduce((sum, b, i) => sum + b * parts[i], 0) < 0 ? -1 : 1;\n    const derivativeShare = read.share(derivativeCutoffHz, seconds);\n    state.speed = state.speed.map(\n      (old, i) => old + derivativeShare * ((sign * parts[i] - before[i]) / seconds - old)\n    );\n    const speed = Math.hypot(...state.speed) * (isRotation ? 2 : 1);\n    const share = read.share(minCutoffHz + beta * speed, seconds);\n    smoothed = before.map((b, i) => {\n      const p = sign * parts[i];\n      return share < 0.5 ? b + share * (p - b) : p - (1 - share) * (p - b);\n    });\n    if (isRotation) {\n      const length = Math.hypot(...smoothed);\n      smoothed = smoothed.map((part) => part / length);\n    }\n  }\n  state.smoothed = smoothed;\n  state.waitedMs = 0;\n  if (typeof value === "number") return { outputs: { smoothed: { double: smoothed[0] } } };\n  const members = Object.fromEntries(names.map((name, i) => [name, smoothed[i]]));\n  return { outputs: { smoothed: { [record.type]: members } } };\n}',
    onCreatedStringified:
      '(state) => { Object.assign(state, (() => ({ smoothed: void 0, speed: [], waitedMs: 0 })\n)()); }',
    extension: {
      version: '1.0.0',
      libraries: [],
      replaceable: false,
      origin: 'MODULE_ORIGIN_UNKNOWN',
      grantIds: [],
    },
  },
  {
    name: 'one-euro-filter-quaternion',
    authors: ['Ubi-Interact'],
    tags: ['filter', 'smoothing', 'one-euro'],
    description:
      'Smooths a quaternion: strongly while it is slow, hardly while it is fast (1€ filter).',
    processingMode: {
      triggerOnInput: {
        minDelayMs: 0,
        allInputsNeedUpdate: false,
      },
    },
    inputs: [
      {
        internalName: 'value',
        messageFormat: 'ubii.dataStructure.Quaternion',
        isRecordList: false,
      },
      {
        internalName: 'minCutoffHz',
        messageFormat: 'double',
        isRecordList: false,
        defaultJson: '{"double":1}',
      },
      {
        internalName: 'beta',
        messageFormat: 'double',
        isRecordList: false,
        defaultJson: '{"double":1}',
      },
      {
        internalName: 'derivativeCutoffHz',
        messageFormat: 'double',
        isRecordList: false,
        defaultJson: '{"double":1}',
      },
    ],
    outputs: [
      {
        internalName: 'smoothed',
        messageFormat: 'ubii.dataStructure.Quaternion',
        isRecordList: false,
      },
    ],
    language: 'JS',
    onProcessingStringified:
      'function smooth2(deltaTimeMs, inputs, state) {\n  const read = {\n    value(record2) {\n      return record2?.double ?? record2?.float ?? record2?.int32;\n    },\n    // What is no finite number counts as not there.\n    number(record2, fallback, min, max) {\n      const value2 = this.value(record2);\n      return Number.isFinite(value2) ? Math.min(max, Math.max(min, value2)) : fallback;\n    },\n    /** How far the smoothed value goes towards a new one: the paper\'s alpha. */\n    share(cutoffHz, seconds) {\n      const turns = 2 * Math.PI * cutoffHz * seconds;\n      return turns === Infinity ? 1 : turns / (turns + 1);\n    }\n  };\n  const minCutoffHz = read.number(inputs.minCutoffHz, 1, 0, 1e3);\n  const beta = read.number(inputs.beta, 1, 0, 1e9);\n  const derivativeCutoffHz = read.number(inputs.derivativeCutoffHz, 1, 0, 1e3);\n  state.waitedMs += deltaTimeMs;\n  const record = inputs.value;\n  const triggers = state.inputTriggerNames ?? [];\n  if (record === void 0 || triggers.length > 0 && !triggers.includes("value"))\n    return void 0;\n  const value = record[record.type];\n  const names = typeof value === "number" ? [] : ["x", "y", "z", "w"].filter((name) => name in value);\n  let parts = typeof value === "number" ? [value] : names.map((name) => value[name]);\n  const isRotation = record.type === "quaternion";\n  if (isRotation) {\n    const length = Math.hypot(...parts);\n    parts = parts.map((part) => part / length);\n  }\n  if (!parts.every((part) => Math.abs(part) <= 1e150)) return void 0;\n  let smoothed = state.smoothed;\n  if (smoothed === void 0 || smoothed.length !== parts.length) {\n    smoothed = parts;\n    state.speed = parts.map(() => 0);\n  } else if (state.waitedMs > 0) {\n    const before = smoothed;\n    const seconds = state.waitedMs / 1e3;\n    const sign = isRotation && before.reduce((sum, b, i) => sum + b * parts[i], 0) < 0 ? -1 : 1;\n    const derivativeShare = read.share(derivativeCutoffHz, seconds);\n    state.speed = state.speed.map(\n      (old, i) => old + derivativeShare * ((sign * parts[i] - before[i]) / seconds - old)\n    );\n    const speed = Math.hypot(...state.speed) * (isRotation ? 2 : 1);\n    const share = read.share(minCutoffHz + beta * speed, seconds);\n    smoothed = before.map((b, i) => {\n      const p = sign * parts[i];\n      return share < 0.5 ? b + share * (p - b) : p - (1 - share) * (p - b);\n    });\n    if (isRotation) {\n      const length = Math.hypot(...smoothed);\n      smoothed = smoothed.map((part) => part / length);\n    }\n  }\n  state.smoothed = smoothed;\n  state.waitedMs = 0;\n  if (typeof value === "number") return { outputs: { smoothed: { double: smoothed[0] } } };\n  const members = Object.fromEntries(names.map((name, i) => [name, smoothed[i]]));\n  return { outputs: { smoothed: { [record.type]: members } } };\n}',
    onCreatedStringified:
      '(state) => { Object.assign(state, (() => ({ smoothed: void 0, speed: [], waitedMs: 0 })\n)()); }',
    extension: {
      version: '1.0.0',
      libraries: [],
      replaceable: false,
      origin: 'MODULE_ORIGIN_UNKNOWN',
      grantIds: [],
    },
  },
  {
    name: 'one-euro-filter-vector2',
    authors: ['Ubi-Interact'],
    tags: ['filter', 'smoothing', 'one-euro'],
    description:
      'Smooths a vector2: strongly while it is slow, hardly while it is fast (1€ filter).',
    processingMode: {
      triggerOnInput: {
        minDelayMs: 0,
        allInputsNeedUpdate: false,
      },
    },
    inputs: [
      {
        internalName: 'value',
        messageFormat: 'ubii.dataStructure.Vector2',
        isRecordList: false,
      },
      {
        internalName: 'minCutoffHz',
        messageFormat: 'double',
        isRecordList: false,
        defaultJson: '{"double":1}',
      },
      {
        internalName: 'beta',
        messageFormat: 'double',
        isRecordList: false,
        defaultJson: '{"double":1}',
      },
      {
        internalName: 'derivativeCutoffHz',
        messageFormat: 'double',
        isRecordList: false,
        defaultJson: '{"double":1}',
      },
    ],
    outputs: [
      {
        internalName: 'smoothed',
        messageFormat: 'ubii.dataStructure.Vector2',
        isRecordList: false,
      },
    ],
    language: 'JS',
    onProcessingStringified:
      'function smooth2(deltaTimeMs, inputs, state) {\n  const read = {\n    value(record2) {\n      return record2?.double ?? record2?.float ?? record2?.int32;\n    },\n    // What is no finite number counts as not there.\n    number(record2, fallback, min, max) {\n      const value2 = this.value(record2);\n      return Number.isFinite(value2) ? Math.min(max, Math.max(min, value2)) : fallback;\n    },\n    /** How far the smoothed value goes towards a new one: the paper\'s alpha. */\n    share(cutoffHz, seconds) {\n      const turns = 2 * Math.PI * cutoffHz * seconds;\n      return turns === Infinity ? 1 : turns / (turns + 1);\n    }\n  };\n  const minCutoffHz = read.number(inputs.minCutoffHz, 1, 0, 1e3);\n  const beta = read.number(inputs.beta, 1, 0, 1e9);\n  const derivativeCutoffHz = read.number(inputs.derivativeCutoffHz, 1, 0, 1e3);\n  state.waitedMs += deltaTimeMs;\n  const record = inputs.value;\n  const triggers = state.inputTriggerNames ?? [];\n  if (record === void 0 || triggers.length > 0 && !triggers.includes("value"))\n    return void 0;\n  const value = record[record.type];\n  const names = typeof value === "number" ? [] : ["x", "y", "z", "w"].filter((name) => name in value);\n  let parts = typeof value === "number" ? [value] : names.map((name) => value[name]);\n  const isRotation = record.type === "quaternion";\n  if (isRotation) {\n    const length = Math.hypot(...parts);\n    parts = parts.map((part) => part / length);\n  }\n  if (!parts.every((part) => Math.abs(part) <= 1e150)) return void 0;\n  let smoothed = state.smoothed;\n  if (smoothed === void 0 || smoothed.length !== parts.length) {\n    smoothed = parts;\n    state.speed = parts.map(() => 0);\n  } else if (state.waitedMs > 0) {\n    const before = smoothed;\n    const seconds = state.waitedMs / 1e3;\n    const sign = isRotation && before.reduce((sum, b, i) => sum + b * parts[i], 0) < 0 ? -1 : 1;\n    const derivativeShare = read.share(derivativeCutoffHz, seconds);\n    state.speed = state.speed.map(\n      (old, i) => old + derivativeShare * ((sign * parts[i] - before[i]) / seconds - old)\n    );\n    const speed = Math.hypot(...state.speed) * (isRotation ? 2 : 1);\n    const share = read.share(minCutoffHz + beta * speed, seconds);\n    smoothed = before.map((b, i) => {\n      const p = sign * parts[i];\n      return share < 0.5 ? b + share * (p - b) : p - (1 - share) * (p - b);\n    });\n    if (isRotation) {\n      const length = Math.hypot(...smoothed);\n      smoothed = smoothed.map((part) => part / length);\n    }\n  }\n  state.smoothed = smoothed;\n  state.waitedMs = 0;\n  if (typeof value === "number") return { outputs: { smoothed: { double: smoothed[0] } } };\n  const members = Object.fromEntries(names.map((name, i) => [name, smoothed[i]]));\n  return { outputs: { smoothed: { [record.type]: members } } };\n}',
    onCreatedStringified:
      '(state) => { Object.assign(state, (() => ({ smoothed: void 0, speed: [], waitedMs: 0 })\n)()); }',
    extension: {
      version: '1.0.0',
      libraries: [],
      replaceable: false,
      origin: 'MODULE_ORIGIN_UNKNOWN',
      grantIds: [],
    },
  },
  {
    name: 'one-euro-filter-vector3',
    authors: ['Ubi-Interact'],
    tags: ['filter', 'smoothing', 'one-euro'],
    description:
      'Smooths a vector3: strongly while it is slow, hardly while it is fast (1€ filter).',
    processingMode: {
      triggerOnInput: {
        minDelayMs: 0,
        allInputsNeedUpdate: false,
      },
    },
    inputs: [
      {
        internalName: 'value',
        messageFormat: 'ubii.dataStructure.Vector3',
        isRecordList: false,
      },
      {
        internalName: 'minCutoffHz',
        messageFormat: 'double',
        isRecordList: false,
        defaultJson: '{"double":1}',
      },
      {
        internalName: 'beta',
        messageFormat: 'double',
        isRecordList: false,
        defaultJson: '{"double":1}',
      },
      {
        internalName: 'derivativeCutoffHz',
        messageFormat: 'double',
        isRecordList: false,
        defaultJson: '{"double":1}',
      },
    ],
    outputs: [
      {
        internalName: 'smoothed',
        messageFormat: 'ubii.dataStructure.Vector3',
        isRecordList: false,
      },
    ],
    language: 'JS',
    onProcessingStringified:
      'function smooth2(deltaTimeMs, inputs, state) {\n  const read = {\n    value(record2) {\n      return record2?.double ?? record2?.float ?? record2?.int32;\n    },\n    // What is no finite number counts as not there.\n    number(record2, fallback, min, max) {\n      const value2 = this.value(record2);\n      return Number.isFinite(value2) ? Math.min(max, Math.max(min, value2)) : fallback;\n    },\n    /** How far the smoothed value goes towards a new one: the paper\'s alpha. */\n    share(cutoffHz, seconds) {\n      const turns = 2 * Math.PI * cutoffHz * seconds;\n      return turns === Infinity ? 1 : turns / (turns + 1);\n    }\n  };\n  const minCutoffHz = read.number(inputs.minCutoffHz, 1, 0, 1e3);\n  const beta = read.number(inputs.beta, 1, 0, 1e9);\n  const derivativeCutoffHz = read.number(inputs.derivativeCutoffHz, 1, 0, 1e3);\n  state.waitedMs += deltaTimeMs;\n  const record = inputs.value;\n  const triggers = state.inputTriggerNames ?? [];\n  if (record === void 0 || triggers.length > 0 && !triggers.includes("value"))\n    return void 0;\n  const value = record[record.type];\n  const names = typeof value === "number" ? [] : ["x", "y", "z", "w"].filter((name) => name in value);\n  let parts = typeof value === "number" ? [value] : names.map((name) => value[name]);\n  const isRotation = record.type === "quaternion";\n  if (isRotation) {\n    const length = Math.hypot(...parts);\n    parts = parts.map((part) => part / length);\n  }\n  if (!parts.every((part) => Math.abs(part) <= 1e150)) return void 0;\n  let smoothed = state.smoothed;\n  if (smoothed === void 0 || smoothed.length !== parts.length) {\n    smoothed = parts;\n    state.speed = parts.map(() => 0);\n  } else if (state.waitedMs > 0) {\n    const before = smoothed;\n    const seconds = state.waitedMs / 1e3;\n    const sign = isRotation && before.reduce((sum, b, i) => sum + b * parts[i], 0) < 0 ? -1 : 1;\n    const derivativeShare = read.share(derivativeCutoffHz, seconds);\n    state.speed = state.speed.map(\n      (old, i) => old + derivativeShare * ((sign * parts[i] - before[i]) / seconds - old)\n    );\n    const speed = Math.hypot(...state.speed) * (isRotation ? 2 : 1);\n    const share = read.share(minCutoffHz + beta * speed, seconds);\n    smoothed = before.map((b, i) => {\n      const p = sign * parts[i];\n      return share < 0.5 ? b + share * (p - b) : p - (1 - share) * (p - b);\n    });\n    if (isRotation) {\n      const length = Math.hypot(...smoothed);\n      smoothed = smoothed.map((part) => part / length);\n    }\n  }\n  state.smoothed = smoothed;\n  state.waitedMs = 0;\n  if (typeof value === "number") return { outputs: { smoothed: { double: smoothed[0] } } };\n  const members = Object.fromEntries(names.map((name, i) => [name, smoothed[i]]));\n  return { outputs: { smoothed: { [record.type]: members } } };\n}',
    onCreatedStringified:
      '(state) => { Object.assign(state, (() => ({ smoothed: void 0, speed: [], waitedMs: 0 })\n)()); }',
    extension: {
      version: '1.0.0',
      libraries: [],
      replaceable: false,
      origin: 'MODULE_ORIGIN_UNKNOWN',
      grantIds: [],
    },
  },
  {
    name: 'one-euro-filter-vector4',
    authors: ['Ubi-Interact'],
    tags: ['filter', 'smoothing', 'one-euro'],
    description:
      'Smooths a vector4: strongly while it is slow, hardly while it is fast (1€ filter).',
    processingMode: {
      triggerOnInput: {
        minDelayMs: 0,
        allInputsNeedUpdate: false,
      },
    },
    inputs: [
      {
        internalName: 'value',
        messageFormat: 'ubii.dataStructure.Vector4',
        isRecordList: false,
      },
      {
        internalName: 'minCutoffHz',
        messageFormat: 'double',
        isRecordList: false,
        defaultJson: '{"double":1}',
      },
      {
        internalName: 'beta',
        messageFormat: 'double',
        isRecordList: false,
        defaultJson: '{"double":1}',
      },
      {
        internalName: 'derivativeCutoffHz',
        messageFormat: 'double',
        isRecordList: false,
        defaultJson: '{"double":1}',
      },
    ],
    outputs: [
      {
        internalName: 'smoothed',
        messageFormat: 'ubii.dataStructure.Vector4',
        isRecordList: false,
      },
    ],
    language: 'JS',
    onProcessingStringified:
      'function smooth2(deltaTimeMs, inputs, state) {\n  const read = {\n    value(record2) {\n      return record2?.double ?? record2?.float ?? record2?.int32;\n    },\n    // What is no finite number counts as not there.\n    number(record2, fallback, min, max) {\n      const value2 = this.value(record2);\n      return Number.isFinite(value2) ? Math.min(max, Math.max(min, value2)) : fallback;\n    },\n    /** How far the smoothed value goes towards a new one: the paper\'s alpha. */\n    share(cutoffHz, seconds) {\n      const turns = 2 * Math.PI * cutoffHz * seconds;\n      return turns === Infinity ? 1 : turns / (turns + 1);\n    }\n  };\n  const minCutoffHz = read.number(inputs.minCutoffHz, 1, 0, 1e3);\n  const beta = read.number(inputs.beta, 1, 0, 1e9);\n  const derivativeCutoffHz = read.number(inputs.derivativeCutoffHz, 1, 0, 1e3);\n  state.waitedMs += deltaTimeMs;\n  const record = inputs.value;\n  const triggers = state.inputTriggerNames ?? [];\n  if (record === void 0 || triggers.length > 0 && !triggers.includes("value"))\n    return void 0;\n  const value = record[record.type];\n  const names = typeof value === "number" ? [] : ["x", "y", "z", "w"].filter((name) => name in value);\n  let parts = typeof value === "number" ? [value] : names.map((name) => value[name]);\n  const isRotation = record.type === "quaternion";\n  if (isRotation) {\n    const length = Math.hypot(...parts);\n    parts = parts.map((part) => part / length);\n  }\n  if (!parts.every((part) => Math.abs(part) <= 1e150)) return void 0;\n  let smoothed = state.smoothed;\n  if (smoothed === void 0 || smoothed.length !== parts.length) {\n    smoothed = parts;\n    state.speed = parts.map(() => 0);\n  } else if (state.waitedMs > 0) {\n    const before = smoothed;\n    const seconds = state.waitedMs / 1e3;\n    const sign = isRotation && before.reduce((sum, b, i) => sum + b * parts[i], 0) < 0 ? -1 : 1;\n    const derivativeShare = read.share(derivativeCutoffHz, seconds);\n    state.speed = state.speed.map(\n      (old, i) => old + derivativeShare * ((sign * parts[i] - before[i]) / seconds - old)\n    );\n    const speed = Math.hypot(...state.speed) * (isRotation ? 2 : 1);\n    const share = read.share(minCutoffHz + beta * speed, seconds);\n    smoothed = before.map((b, i) => {\n      const p = sign * parts[i];\n      return share < 0.5 ? b + share * (p - b) : p - (1 - share) * (p - b);\n    });\n    if (isRotation) {\n      const length = Math.hypot(...smoothed);\n      smoothed = smoothed.map((part) => part / length);\n    }\n  }\n  state.smoothed = smoothed;\n  state.waitedMs = 0;\n  if (typeof value === "number") return { outputs: { smoothed: { double: smoothed[0] } } };\n  const members = Object.fromEntries(names.map((name, i) => [name, smoothed[i]]));\n  return { outputs: { smoothed: { [record.type]: members } } };\n}',
    onCreatedStringified:
      '(state) => { Object.assign(state, (() => ({ smoothed: void 0, speed: [], waitedMs: 0 })\n)()); }',
    extension: {
      version: '1.0.0',
      libraries: [],
      replaceable: false,
      origin: 'MODULE_ORIGIN_UNKNOWN',
      grantIds: [],
    },
  },
  {
    name: 'pick-field',
    authors: ['Ubi-Interact'],
    tags: ['field', 'convert', 'number', 'vector', 'text'],
    description: 'Takes one part out of a value, such as position.x out of a pose.',
    processingMode: {
      triggerOnInput: {
        minDelayMs: 0,
        allInputsNeedUpdate: false,
      },
    },
    inputs: [
      {
        internalName: 'value',
        messageFormat: 'ubii.dataStructure.Pose3D',
        isRecordList: false,
      },
      {
        internalName: 'path',
        messageFormat: 'string',
        isRecordList: false,
      },
    ],
    outputs: [
      {
        internalName: 'number',
        messageFormat: 'double',
        isRecordList: false,
      },
      {
        internalName: 'isTrue',
        messageFormat: 'bool',
        isRecordList: false,
      },
      {
        internalName: 'text',
        messageFormat: 'string',
        isRecordList: false,
      },
      {
        internalName: 'vector2',
        messageFormat: 'ubii.dataStructure.Vector2',
        isRecordList: false,
      },
      {
        internalName: 'vector3',
        messageFormat: 'ubii.dataStructure.Vector3',
        isRecordList: false,
      },
      {
        internalName: 'vector4',
        messageFormat: 'ubii.dataStructure.Vector4',
        isRecordList: false,
      },
      {
        internalName: 'quaternion',
        messageFormat: 'ubii.dataStructure.Quaternion',
        isRecordList: false,
      },
      {
        internalName: 'color',
        messageFormat: 'ubii.dataStructure.Color',
        isRecordList: false,
      },
      {
        internalName: 'error',
        messageFormat: 'string',
        isRecordList: false,
      },
    ],
    language: 'JS',
    onProcessingStringified:
      '({ onProcessing(_deltaTimeMs, inputs, state) {\n    const read = {\n      /** The part at the path, or what is wrong. */\n      part(whole, path) {\n        let part2 = whole;\n        for (const key of path.replace(/\\[(\\d+)\\]/g, ".$1").split(".")) {\n          if (key === "" || key === "$") continue;\n          if (typeof part2 !== "object" || part2 === null || !Object.hasOwn(part2, key)) {\n            return { reason: `The value has no "${path}": there is no "${key}".` };\n          }\n          part2 = part2[key];\n        }\n        return { part: part2 };\n      },\n      /** The members by name, when all of them are finite numbers. */\n      numbers(part2, ...names) {\n        if (typeof part2 !== "object" || part2 === null) return void 0;\n        const all = part2;\n        const entries = names.map((name) => [name, all[name]]);\n        if (!entries.every(([, value]) => Number.isFinite(value))) return void 0;\n        return Object.fromEntries(entries);\n      }\n    };\n    const record = inputs.value;\n    if (record === void 0) return void 0;\n    const result = read.part(record[record.type], inputs.path?.string.trim() ?? "");\n    const error = "reason" in result ? result.reason : "";\n    const hasNewError = error !== state.error;\n    state.error = error;\n    const part = "part" in result ? result.part : void 0;\n    const number = typeof part === "boolean" ? Number(part) : part;\n    const vector2 = read.numbers(part, "x", "y");\n    const vector3 = read.numbers(part, "x", "y", "z");\n    const vector4 = read.numbers(part, "x", "y", "z", "w");\n    const color = read.numbers(part, "r", "g", "b", "a");\n    const isText = typeof part === "string" || typeof part === "number" || part === !!part;\n    return {\n      outputs: {\n        number: Number.isFinite(number) ? { double: number } : void 0,\n        isTrue: typeof part === "boolean" ? { bool: part } : void 0,\n        text: isText ? { string: String(part) } : void 0,\n        vector2: vector2 && { vector2 },\n        vector3: vector3 && { vector3 },\n        vector4: vector4 && { vector4 },\n        quaternion: vector4 && { quaternion: vector4 },\n        color: color && { color },\n        error: hasNewError ? { string: error } : void 0\n      }\n    };\n  } })["onProcessing"]',
    onCreatedStringified: '(state) => { Object.assign(state, (() => ({ error: "" })\n)()); }',
    extension: {
      version: '1.0.0',
      libraries: [],
      replaceable: false,
      origin: 'MODULE_ORIGIN_UNKNOWN',
      grantIds: [],
    },
  },
  {
    name: 'picture-edges',
    authors: ['Ubi-Interact'],
    tags: ['image', 'filter', 'edge'],
    description: 'Turns a picture of raw pixels into grey, and finds its edges (Sobel operator).',
    processingMode: {
      triggerOnInput: {
        minDelayMs: 0,
        allInputsNeedUpdate: false,
      },
    },
    inputs: [
      {
        internalName: 'picture',
        messageFormat: 'ubii.dataStructure.Image2D',
        isRecordList: false,
      },
      {
        internalName: 'threshold',
        messageFormat: 'double',
        isRecordList: false,
        defaultJson: '{"double":0}',
      },
    ],
    outputs: [
      {
        internalName: 'grey',
        messageFormat: 'ubii.dataStructure.Image2D',
        isRecordList: false,
      },
      {
        internalName: 'edges',
        messageFormat: 'ubii.dataStructure.Image2D',
        isRecordList: false,
      },
      {
        internalName: 'error',
        messageFormat: 'string',
        isRecordList: false,
      },
    ],
    language: 'JS',
    onProcessingStringified:
      '({ onProcessing(_deltaTimeMs, inputs, state) {\n    const read = {\n      value(record) {\n        return record?.double ?? record?.float ?? record?.int32;\n      },\n      // What is not a finite number counts as missing.\n      number(record, fallback, min, max) {\n        const value = this.value(record);\n        return Number.isFinite(value) ? Math.min(max, Math.max(min, value)) : fallback;\n      }\n    };\n    const picture = inputs.picture?.image2D;\n    if (picture === void 0) return void 0;\n    const { width, height, data } = picture;\n    const channels = Number(picture.dataFormat) === 1 ? 3 : Number(picture.dataFormat) === 2 ? 4 : 1;\n    const size = width * height;\n    let error = "";\n    if (!(width > 0 && height > 0 && data?.length === size * channels)) {\n      error = `The picture has ${data?.length ?? 0} bytes instead of ${size * channels}. Send raw pixels: GRAY8, RGB8 or RGBA8.`;\n    } else if (size > 640 * 480) {\n      error = `The picture has ${width} \\xD7 ${height} pixels. Send at most 640 \\xD7 480.`;\n    }\n    const isNew = error !== state.error;\n    state.error = error;\n    if (error !== "") return isNew ? { outputs: { error: { string: error } } } : void 0;\n    const grey = new Uint8Array(size);\n    for (let pixel = 0; pixel < size; pixel++) {\n      const at = pixel * channels;\n      grey[pixel] = channels === 1 ? data[at] : 0.299 * data[at] + 0.587 * data[at + 1] + 0.114 * data[at + 2] + 0.5;\n    }\n    const threshold2 = 255 * read.number(inputs.threshold, 0, 0, 1);\n    const edges = new Uint8Array(size);\n    for (let y = 1; y < height - 1; y++) {\n      for (let x = 1; x < width - 1; x++) {\n        const at = y * width + x;\n        const up = at - width;\n        const down = at + width;\n        const dx = grey[up + 1] - grey[up - 1] + 2 * (grey[at + 1] - grey[at - 1]) + grey[down + 1] - grey[down - 1];\n        const dy = grey[down - 1] - grey[up - 1] + 2 * (grey[down] - grey[up]) + grey[down + 1] - grey[up + 1];\n        const strength = Math.min(255, Math.sqrt(dx * dx + dy * dy));\n        edges[at] = threshold2 === 0 ? strength : strength >= threshold2 ? 255 : 0;\n      }\n    }\n    return {\n      outputs: {\n        grey: { image2D: { width, height, dataFormat: 0, data: grey } },\n        edges: { image2D: { width, height, dataFormat: 0, data: edges } },\n        error: isNew ? { string: "" } : void 0\n      }\n    };\n  } })["onProcessing"]',
    onCreatedStringified: '(state) => { Object.assign(state, (() => ({ error: "" })\n)()); }',
    extension: {
      version: '1.0.0',
      libraries: [],
      replaceable: false,
      origin: 'MODULE_ORIGIN_UNKNOWN',
      grantIds: [],
    },
  },
  {
    name: 'position-color',
    authors: ['Ubi-Interact'],
    tags: ['color', 'vector', 'pointer', 'convert'],
    description: 'Turns a position from 0 to 1 into a colour: hue by x, lightness by y.',
    processingMode: {
      triggerOnInput: {
        minDelayMs: 0,
        allInputsNeedUpdate: false,
      },
    },
    inputs: [
      {
        internalName: 'position',
        messageFormat: 'ubii.dataStructure.Vector2',
        isRecordList: false,
      },
      {
        internalName: 'saturation',
        messageFormat: 'double',
        isRecordList: false,
        defaultJson: '{"double":0.8}',
      },
    ],
    outputs: [
      {
        internalName: 'color',
        messageFormat: 'ubii.dataStructure.Color',
        isRecordList: false,
      },
      {
        internalName: 'hex',
        messageFormat: 'string',
        isRecordList: false,
      },
    ],
    language: 'JS',
    onProcessingStringified:
      '({ onProcessing(_deltaTimeMs, inputs) {\n    const read = {\n      value(record) {\n        return record?.double ?? record?.float ?? record?.int32;\n      },\n      // What is not a finite number counts as missing.\n      number(record, fallback) {\n        const value = this.value(record);\n        return Number.isFinite(value) ? Math.min(1, Math.max(0, value)) : fallback;\n      }\n    };\n    const position = inputs.position?.vector2;\n    if (!position || !Number.isFinite(position.x) || !Number.isFinite(position.y)) return void 0;\n    const saturation = read.number(inputs.saturation, 0.8);\n    const hue = (position.x % 1 + 1) % 1;\n    const lightness = 0.85 - 0.65 * Math.min(1, Math.max(0, position.y));\n    const chroma = saturation * Math.min(lightness, 1 - lightness);\n    const channels = [0, 8, 4].map((n) => {\n      const k = (n + hue * 12) % 12;\n      return lightness - chroma * Math.max(-1, Math.min(k - 3, 9 - k, 1));\n    });\n    const [r = 0, g = 0, b = 0] = channels;\n    const hex = channels.map(\n      (part) => Math.round(part * 255).toString(16).padStart(2, "0")\n    );\n    return {\n      outputs: { color: { color: { r, g, b, a: 1 } }, hex: { string: `#${hex.join("")}` } }\n    };\n  } })["onProcessing"]',
    extension: {
      version: '1.0.0',
      libraries: [],
      replaceable: false,
      origin: 'MODULE_ORIGIN_UNKNOWN',
      grantIds: [],
    },
  },
  {
    name: 'speed-vector2',
    authors: ['Ubi-Interact'],
    tags: ['vector', 'number', 'derivative', 'pointer'],
    description: 'Gives velocity, speed and distance travelled of a position.',
    processingMode: {
      frequency: {
        hertz: 30,
      },
    },
    inputs: [
      {
        internalName: 'position',
        messageFormat: 'ubii.dataStructure.Vector2',
        isRecordList: false,
      },
      {
        internalName: 'smoothingMs',
        messageFormat: 'double',
        isRecordList: false,
        defaultJson: '{"double":60}',
      },
    ],
    outputs: [
      {
        internalName: 'velocity',
        messageFormat: 'ubii.dataStructure.Vector2',
        isRecordList: false,
      },
      {
        internalName: 'speed',
        messageFormat: 'double',
        isRecordList: false,
      },
      {
        internalName: 'distance',
        messageFormat: 'double',
        isRecordList: false,
      },
    ],
    language: 'JS',
    onProcessingStringified:
      '({ onProcessing(deltaTimeMs, inputs, state) {\n    const read = {\n      value(record) {\n        return record?.double ?? record?.float ?? record?.int32;\n      },\n      // What is not a finite number counts as missing.\n      number(record, fallback, min, max) {\n        const value = this.value(record);\n        return Number.isFinite(value) ? Math.min(max, Math.max(min, value)) : fallback;\n      }\n    };\n    const smoothingMs = read.number(inputs.smoothingMs, 60, 0, 6e4);\n    state.waitedMs += deltaTimeMs;\n    const position = inputs.position?.vector2;\n    const triggers = state.inputTriggerNames ?? [];\n    if (position === void 0 || triggers.length > 0 && !triggers.includes("position"))\n      return void 0;\n    if (![position.x, position.y].every((part) => Math.abs(part) <= 1e100)) return void 0;\n    const { x, y } = position;\n    const last = state.last;\n    if (last !== void 0 && state.waitedMs <= 0) return void 0;\n    if (last !== void 0) {\n      const seconds = state.waitedMs / 1e3;\n      const way = { x: x - last.x, y: y - last.y };\n      state.distance += Math.hypot(way.x, way.y);\n      const share = smoothingMs === 0 ? 1 : -Math.expm1(-state.waitedMs / smoothingMs);\n      state.velocity = {\n        x: state.velocity.x + share * (way.x / seconds - state.velocity.x),\n        y: state.velocity.y + share * (way.y / seconds - state.velocity.y)\n      };\n    }\n    state.last = { x, y };\n    state.waitedMs = 0;\n    return {\n      outputs: {\n        velocity: { vector2: state.velocity },\n        speed: { double: Math.hypot(state.velocity.x, state.velocity.y) },\n        distance: { double: state.distance }\n      }\n    };\n  } })["onProcessing"]',
    onCreatedStringified:
      '(state) => { Object.assign(state, (() => ({\n    last: void 0,\n    waitedMs: 0,\n    velocity: { x: 0, y: 0 },\n    distance: 0\n  })\n)()); }',
    extension: {
      version: '1.0.0',
      libraries: [],
      replaceable: false,
      origin: 'MODULE_ORIGIN_UNKNOWN',
      grantIds: [],
    },
  },
  {
    name: 'statistics',
    authors: ['Ubi-Interact'],
    tags: ['number', 'statistics', 'window'],
    description:
      'Count, mean, minimum, maximum, standard deviation and root mean square of the newest values.',
    processingMode: {
      triggerOnInput: {
        minDelayMs: 0,
        allInputsNeedUpdate: false,
      },
    },
    inputs: [
      {
        internalName: 'value',
        messageFormat: 'double',
        isRecordList: false,
      },
      {
        internalName: 'windowMs',
        messageFormat: 'double',
        isRecordList: false,
        defaultJson: '{"double":1000}',
      },
      {
        internalName: 'windowCount',
        messageFormat: 'int32',
        isRecordList: false,
        defaultJson: '{"int32":0}',
      },
    ],
    outputs: [
      {
        internalName: 'count',
        messageFormat: 'int32',
        isRecordList: false,
      },
      {
        internalName: 'mean',
        messageFormat: 'double',
        isRecordList: false,
      },
      {
        internalName: 'min',
        messageFormat: 'double',
        isRecordList: false,
      },
      {
        internalName: 'max',
        messageFormat: 'double',
        isRecordList: false,
      },
      {
        internalName: 'standardDeviation',
        messageFormat: 'double',
        isRecordList: false,
      },
      {
        internalName: 'rms',
        messageFormat: 'double',
        isRecordList: false,
      },
    ],
    language: 'JS',
    onProcessingStringified:
      '({ onProcessing(deltaTimeMs, inputs, state) {\n    const read = {\n      value(record) {\n        return record?.double ?? record?.float ?? record?.int32;\n      },\n      // What is no finite number counts as not there.\n      number(record, fallback, min, max) {\n        const value2 = this.value(record);\n        return Number.isFinite(value2) ? Math.min(max, Math.max(min, value2)) : fallback;\n      }\n    };\n    const aggregate = {\n      none() {\n        return { count: 0, mean: 0, m2: 0, min: Infinity, max: -Infinity };\n      },\n      one(value2) {\n        return { count: 1, mean: value2, m2: 0, min: value2, max: value2 };\n      },\n      merge(a, b) {\n        if (a.count === 0) return b;\n        if (b.count === 0) return a;\n        const count = a.count + b.count;\n        const delta = b.mean - a.mean;\n        return {\n          count,\n          mean: a.mean + delta * b.count / count,\n          m2: a.m2 + b.m2 + delta * delta * a.count * b.count / count,\n          min: Math.min(a.min, b.min),\n          max: Math.max(a.max, b.max)\n        };\n      }\n    };\n    const windowMs = read.number(inputs.windowMs, 1e3, 0, Number.MAX_VALUE);\n    const windowCount = Math.floor(read.number(inputs.windowCount, 0, 0, 1e4)) || 1e4;\n    state.nowMs += deltaTimeMs;\n    const value = read.value(inputs.value);\n    const isUsable = value !== void 0 && Math.abs(value) <= 1e140;\n    const triggers = state.inputTriggerNames ?? [];\n    const isNew = triggers.length === 0 || triggers.includes("value");\n    if (isUsable && isNew) {\n      state.newer.push({ atMs: state.nowMs, value });\n      state.newerAggregate = aggregate.merge(state.newerAggregate, aggregate.one(value));\n    }\n    for (; ; ) {\n      if (state.older.length === 0) {\n        let merged = aggregate.none();\n        for (const { atMs, value: sample } of state.newer.reverse()) {\n          merged = aggregate.merge(aggregate.one(sample), merged);\n          state.older.push({ atMs, aggregate: merged });\n        }\n        state.newer = [];\n        state.newerAggregate = aggregate.none();\n      }\n      const oldest2 = state.older.at(-1);\n      if (oldest2 === void 0) break;\n      const isTooOld = windowMs > 0 && state.nowMs - oldest2.atMs >= windowMs;\n      if (!isTooOld && state.older.length + state.newer.length <= windowCount) break;\n      state.older.pop();\n    }\n    const oldest = state.older.at(-1);\n    const all = aggregate.merge(oldest?.aggregate ?? aggregate.none(), state.newerAggregate);\n    if (all.count === 0) return { outputs: { count: { int32: 0 } } };\n    return {\n      outputs: {\n        count: { int32: all.count },\n        mean: { double: all.mean },\n        min: { double: all.min },\n        max: { double: all.max },\n        standardDeviation: { double: all.count > 1 ? Math.sqrt(all.m2 / (all.count - 1)) : 0 },\n        rms: { double: Math.sqrt(all.mean * all.mean + all.m2 / all.count) }\n      }\n    };\n  } })["onProcessing"]',
    onCreatedStringified:
      '(state) => { Object.assign(state, (() => ({\n    nowMs: 0,\n    older: [],\n    newer: [],\n    newerAggregate: { count: 0, mean: 0, m2: 0, min: Infinity, max: -Infinity }\n  })\n)()); }',
    extension: {
      version: '1.0.0',
      libraries: [],
      replaceable: false,
      origin: 'MODULE_ORIGIN_UNKNOWN',
      grantIds: [],
    },
  },
  {
    name: 'test-picture',
    authors: ['Ubi-Interact'],
    tags: ['source', 'generator', 'image'],
    description:
      'Generates a moving picture in colour, so that no camera is needed to work with images.',
    processingMode: {
      frequency: {
        hertz: 12,
      },
    },
    inputs: [
      {
        internalName: 'width',
        messageFormat: 'int32',
        isRecordList: false,
        defaultJson: '{"int32":96}',
      },
      {
        internalName: 'height',
        messageFormat: 'int32',
        isRecordList: false,
        defaultJson: '{"int32":54}',
      },
      {
        internalName: 'turnsPerSecond',
        messageFormat: 'double',
        isRecordList: false,
        defaultJson: '{"double":0.2}',
      },
    ],
    outputs: [
      {
        internalName: 'picture',
        messageFormat: 'ubii.dataStructure.Image2D',
        isRecordList: false,
      },
    ],
    language: 'JS',
    onProcessingStringified:
      '({ onProcessing(deltaTimeMs, inputs, state) {\n    const read = {\n      value(record) {\n        return record?.double ?? record?.float ?? record?.int32;\n      },\n      // What is not a finite number counts as missing.\n      number(record, fallback, min, max) {\n        const value = this.value(record);\n        return Number.isFinite(value) ? Math.min(max, Math.max(min, value)) : fallback;\n      }\n    };\n    const width = Math.round(read.number(inputs.width, 96, 16, 320));\n    const height = Math.round(read.number(inputs.height, 54, 16, 240));\n    const turnsPerSecond = read.number(inputs.turnsPerSecond, 0.2, 0, 10);\n    state.turns = (state.turns + turnsPerSecond * deltaTimeMs / 1e3) % 1;\n    const angle = 2 * Math.PI * state.turns;\n    const discX = width * (0.5 + 0.34 * Math.cos(angle));\n    const discY = height * (0.5 + 0.26 * Math.sin(2 * angle));\n    const radius = height * 0.22;\n    const barWidth = width / 8;\n    const data = new Uint8Array(width * height * 3);\n    let at = 0;\n    for (let y = 0; y < height; y++) {\n      const shade = 40 + 90 * y / height;\n      for (let x = 0; x < width; x++) {\n        const isDisc = (x - discX) ** 2 + (y - discY) ** 2 < radius ** 2;\n        const isBar = y > height * 0.7 && Math.floor(x / barWidth) % 2 === 0;\n        data[at++] = isDisc ? 250 : isBar ? 30 : shade;\n        data[at++] = isDisc ? 200 : isBar ? 120 : shade + 20;\n        data[at++] = isDisc ? 90 : isBar ? 170 : shade + 60;\n      }\n    }\n    return { outputs: { picture: { image2D: { width, height, dataFormat: 1, data } } } };\n  } })["onProcessing"]',
    onCreatedStringified: '(state) => { Object.assign(state, (() => ({ turns: 0 })\n)()); }',
    extension: {
      version: '1.0.0',
      libraries: [],
      replaceable: false,
      origin: 'MODULE_ORIGIN_UNKNOWN',
      grantIds: [],
    },
  },
  {
    name: 'threshold',
    authors: ['Ubi-Interact'],
    tags: ['event', 'number', 'edge'],
    description:
      'Tells when a number rises to a threshold and when it falls below it, with hysteresis.',
    processingMode: {
      triggerOnInput: {
        minDelayMs: 0,
        allInputsNeedUpdate: false,
      },
    },
    inputs: [
      {
        internalName: 'value',
        messageFormat: 'double',
        isRecordList: false,
      },
      {
        internalName: 'threshold',
        messageFormat: 'double',
        isRecordList: false,
        defaultJson: '{"double":0.5}',
      },
      {
        internalName: 'hysteresis',
        messageFormat: 'double',
        isRecordList: false,
        defaultJson: '{"double":0}',
      },
    ],
    outputs: [
      {
        internalName: 'isAbove',
        messageFormat: 'bool',
        isRecordList: false,
      },
      {
        internalName: 'rose',
        messageFormat: 'bool',
        isRecordList: false,
      },
      {
        internalName: 'fell',
        messageFormat: 'bool',
        isRecordList: false,
      },
      {
        internalName: 'riseCount',
        messageFormat: 'int32',
        isRecordList: false,
      },
    ],
    language: 'JS',
    onProcessingStringified:
      '({ onProcessing(_deltaTimeMs, inputs, state) {\n    const read = {\n      value(record) {\n        return record?.double ?? record?.float ?? record?.int32;\n      },\n      // What is no finite number counts as not there.\n      number(record, fallback, min, max) {\n        const value2 = this.value(record);\n        return Number.isFinite(value2) ? Math.min(max, Math.max(min, value2)) : fallback;\n      }\n    };\n    const value = read.value(inputs.value);\n    if (value === void 0 || Number.isNaN(value)) return void 0;\n    const upper = read.number(inputs.threshold, 0.5, -Number.MAX_VALUE, Number.MAX_VALUE);\n    const lower = upper - read.number(inputs.hysteresis, 0, 0, Number.MAX_VALUE);\n    const before = state.isAbove;\n    const isAbove = before === true ? value >= lower : value >= upper;\n    if (isAbove === before) return void 0;\n    state.isAbove = isAbove;\n    if (before === void 0) return { outputs: { isAbove: { bool: isAbove } } };\n    if (!isAbove) return { outputs: { isAbove: { bool: false }, fell: { bool: true } } };\n    state.riseCount = (state.riseCount + 1) % 2 ** 31;\n    return {\n      outputs: {\n        isAbove: { bool: true },\n        rose: { bool: true },\n        riseCount: { int32: state.riseCount }\n      }\n    };\n  } })["onProcessing"]',
    onCreatedStringified:
      '(state) => { Object.assign(state, (() => ({\n    isAbove: void 0,\n    riseCount: 0\n  })\n)()); }',
    extension: {
      version: '1.0.0',
      libraries: [],
      replaceable: false,
      origin: 'MODULE_ORIGIN_UNKNOWN',
      grantIds: [],
    },
  },
  {
    name: 'touch-proximity',
    authors: ['Ubi-Interact'],
    tags: ['touch', 'muxer', 'demuxer', 'example'],
    description:
      'Finds touches of different people that are near one another, and lets their phones vibrate.',
    processingMode: {
      frequency: {
        hertz: 20,
      },
    },
    inputs: [
      {
        internalName: 'touches',
        messageFormat: 'ubii.dataStructure.Vector2',
        isRecordList: true,
      },
      {
        internalName: 'touching',
        messageFormat: 'bool',
        isRecordList: true,
      },
      {
        internalName: 'distance',
        messageFormat: 'double',
        isRecordList: false,
        defaultJson: '{"double":0.1}',
      },
      {
        internalName: 'hysteresis',
        messageFormat: 'double',
        isRecordList: false,
        defaultJson: '{"double":0.02}',
      },
      {
        internalName: 'vibrationMs',
        messageFormat: 'double',
        isRecordList: false,
        defaultJson: '{"double":100}',
      },
      {
        internalName: 'maxAgeMs',
        messageFormat: 'double',
        isRecordList: false,
        defaultJson: '{"double":2000}',
      },
    ],
    outputs: [
      {
        internalName: 'vibration',
        messageFormat: 'double',
        isRecordList: true,
      },
      {
        internalName: 'isNear',
        messageFormat: 'bool',
        isRecordList: true,
      },
      {
        internalName: 'nearCount',
        messageFormat: 'int32',
        isRecordList: false,
      },
    ],
    language: 'JS',
    onProcessingStringified:
      '({ onProcessing(deltaTimeMs, inputs, state) {\n    const read = {\n      value(record) {\n        return record?.double ?? record?.float ?? record?.int32;\n      },\n      // What is no finite number counts as not there.\n      number(record, fallback, min, max) {\n        const value = this.value(record);\n        return Number.isFinite(value) ? Math.min(max, Math.max(min, value)) : fallback;\n      }\n    };\n    const distance = read.number(inputs.distance, 0.1, 0, 1e9);\n    const farDistance = distance + read.number(inputs.hysteresis, 0.02, 0, 1e9);\n    const vibrationMs = read.number(inputs.vibrationMs, 100, 0, 1e4);\n    const maxAgeMs = read.number(inputs.maxAgeMs, 2e3, 0, Number.MAX_VALUE);\n    state.nowMs += deltaTimeMs;\n    const lifted = /* @__PURE__ */ Object.create(null);\n    for (const { identity, bool } of inputs.touching?.elements ?? []) {\n      if (identity !== void 0) lifted[identity] = !bool;\n    }\n    const touches = [];\n    const seen = /* @__PURE__ */ Object.create(null);\n    for (const element of inputs.touches?.elements ?? []) {\n      const { identity, topic, timestamp, vector2 } = element;\n      if (identity === void 0 || identity === "" || lifted[identity] === true) continue;\n      if (!Number.isFinite(vector2.x) || !Number.isFinite(vector2.y)) continue;\n      const { seconds, nanos, millis } = timestamp ?? { seconds: 0, nanos: 0, millis: 0 };\n      const stamp = [seconds, nanos, millis, vector2.x, vector2.y].join();\n      const before = state.seen[topic];\n      const sinceMs = before?.stamp === stamp ? before.sinceMs : state.nowMs;\n      seen[topic] = { stamp, sinceMs };\n      if (maxAgeMs > 0 && state.nowMs - sinceMs > maxAgeMs) continue;\n      touches.push({ identity, x: vector2.x, y: vector2.y });\n    }\n    state.seen = seen;\n    touches.sort((a, b) => a.x - b.x);\n    const near = /* @__PURE__ */ Object.create(null);\n    for (const [index, a] of touches.entries()) {\n      for (let other = index + 1; other < touches.length; other++) {\n        const b = touches[other];\n        if (b.x - a.x > farDistance) break;\n        const squared = (b.x - a.x) ** 2 + (b.y - a.y) ** 2;\n        if (squared > farDistance ** 2 || a.identity === b.identity) continue;\n        const needsBefore = squared > distance ** 2;\n        if (needsBefore && !state.touchers[a.identity]?.isNear) continue;\n        if (needsBefore && !state.touchers[b.identity]?.isNear) continue;\n        near[a.identity] = true;\n        near[b.identity] = true;\n      }\n    }\n    const touchers = /* @__PURE__ */ Object.create(null);\n    const changed = [];\n    const vibrating = [];\n    for (const identity of new Set(touches.map((touch) => touch.identity))) {\n      const before = state.touchers[identity];\n      const isNear = near[identity] === true;\n      let quietUntilMs = before?.quietUntilMs ?? 0;\n      let toldUntilMs = before?.toldUntilMs ?? 0;\n      const isDue = isNear && state.nowMs >= toldUntilMs;\n      if (isDue || isNear !== (before?.isNear ?? false)) {\n        changed.push({ bool: isNear, outputTopicParams: [identity] });\n        toldUntilMs = state.nowMs + 500;\n      }\n      if (isNear && vibrationMs > 0 && state.nowMs >= quietUntilMs) {\n        vibrating.push({ double: vibrationMs, outputTopicParams: [identity] });\n        quietUntilMs = state.nowMs + vibrationMs;\n      }\n      touchers[identity] = { isNear, quietUntilMs, toldUntilMs };\n    }\n    for (const [identity, toucher] of Object.entries(state.touchers)) {\n      if (toucher.isNear && touchers[identity] === void 0) {\n        changed.push({ bool: false, outputTopicParams: [identity] });\n      }\n    }\n    state.touchers = touchers;\n    return {\n      outputs: {\n        vibration: { elements: vibrating },\n        isNear: { elements: changed },\n        nearCount: { int32: Object.keys(near).length }\n      }\n    };\n  } })["onProcessing"]',
    onCreatedStringified:
      '(state) => { Object.assign(state, (() => ({\n    nowMs: 0,\n    touchers: /* @__PURE__ */ Object.create(null),\n    seen: /* @__PURE__ */ Object.create(null)\n  })\n)()); }',
    extension: {
      version: '1.1.0',
      libraries: [],
      replaceable: false,
      origin: 'MODULE_ORIGIN_UNKNOWN',
      grantIds: [],
    },
  },
];
