// Made by `pnpm --filter @ubii/modules generate` from the definitions. Do not change it by hand.
import type { JsonObject } from '@ubii/proto';

/** Every module of the library as JSON, from a to z. */
export const LIBRARY: readonly JsonObject[] = [
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
      },
      {
        internalName: 'amplitude',
        messageFormat: 'double',
        isRecordList: false,
      },
      {
        internalName: 'offset',
        messageFormat: 'double',
        isRecordList: false,
      },
      {
        internalName: 'phase',
        messageFormat: 'double',
        isRecordList: false,
      },
      {
        internalName: 'dutyCycle',
        messageFormat: 'double',
        isRecordList: false,
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
      },
      {
        internalName: 'timeoutMs',
        messageFormat: 'double',
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
      },
      {
        internalName: 'inMax',
        messageFormat: 'double',
        isRecordList: false,
      },
      {
        internalName: 'outMin',
        messageFormat: 'double',
        isRecordList: false,
      },
      {
        internalName: 'outMax',
        messageFormat: 'double',
        isRecordList: false,
      },
      {
        internalName: 'clamp',
        messageFormat: 'bool',
        isRecordList: false,
      },
      {
        internalName: 'invert',
        messageFormat: 'bool',
        isRecordList: false,
      },
      {
        internalName: 'exponent',
        messageFormat: 'double',
        isRecordList: false,
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
      },
      {
        internalName: 'mirrorY',
        messageFormat: 'bool',
        isRecordList: false,
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
      },
      {
        internalName: 'beta',
        messageFormat: 'double',
        isRecordList: false,
      },
      {
        internalName: 'derivativeCutoffHz',
        messageFormat: 'double',
        isRecordList: false,
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
      },
      {
        internalName: 'beta',
        messageFormat: 'double',
        isRecordList: false,
      },
      {
        internalName: 'derivativeCutoffHz',
        messageFormat: 'double',
        isRecordList: false,
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
      },
      {
        internalName: 'beta',
        messageFormat: 'double',
        isRecordList: false,
      },
      {
        internalName: 'derivativeCutoffHz',
        messageFormat: 'double',
        isRecordList: false,
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
      },
      {
        internalName: 'beta',
        messageFormat: 'double',
        isRecordList: false,
      },
      {
        internalName: 'derivativeCutoffHz',
        messageFormat: 'double',
        isRecordList: false,
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
      },
      {
        internalName: 'beta',
        messageFormat: 'double',
        isRecordList: false,
      },
      {
        internalName: 'derivativeCutoffHz',
        messageFormat: 'double',
        isRecordList: false,
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
      },
      {
        internalName: 'windowCount',
        messageFormat: 'int32',
        isRecordList: false,
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
      },
      {
        internalName: 'hysteresis',
        messageFormat: 'double',
        isRecordList: false,
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
      },
      {
        internalName: 'hysteresis',
        messageFormat: 'double',
        isRecordList: false,
      },
      {
        internalName: 'vibrationMs',
        messageFormat: 'double',
        isRecordList: false,
      },
      {
        internalName: 'maxAgeMs',
        messageFormat: 'double',
        isRecordList: false,
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
