import { defineProcessingModule } from '@ubii/pm-sandbox';
import type { NumberRecord } from '../number-record.ts';

/** Library of a node that requests URLs of the origins that its operator allows. */
interface HttpLibrary {
  /** Rejects when there is no response, or when the origin is not allowed. */
  get(url: string): Promise<{ status: number; text: string }>;
}

interface PollerState {
  /** Milliseconds since the first run. */
  nowMs: number;
  /** Time of the next request, milliseconds since the first run. */
  dueMs: number;
  /** The pending request and its response; undefined when there is none. */
  request: { url: string; sinceMs: number; answer: PollerAnswer | undefined } | undefined;
  /** The newest error that was published; empty after a success. */
  error: string;
}

type PollerAnswer = { status: number; text: string } | { reason: string };

/**
 * Requests a URL periodically and publishes one value of the JSON response: an input for devices with a
 * web service. A request does not block a run: each run starts a request or checks the pending one.
 */
export const httpPoller = defineProcessingModule({
  name: 'http-poller',
  description: 'Requests a URL, and publishes one JSON value.',
  tags: ['source', 'http', 'json', 'rest', 'iot'],
  authors: ['Ubi-Interact'],
  version: '1.0.0',
  libraries: ['http'],
  inputs: {
    url: { format: 'string', description: 'Address to request, http or https.' },
    path: {
      format: 'string',
      description:
        'Path of the value in the response, such as main.temp or sensors[0].value; empty: the whole response.',
    },
    intervalMs: {
      format: 'double',
      default: 1000,
      description: 'Interval of requests, 100 to 86 400 000 ms.',
    },
    timeoutMs: {
      format: 'double',
      default: 10000,
      description: 'Timeout of a response, 100 to 600 000 ms.',
    },
  },
  outputs: {
    number: {
      format: 'double',
      description: 'The value, if it is a number; true is 1, false is 0.',
    },
    text: { format: 'string', description: 'The value as text; objects and lists are JSON.' },
    status: { format: 'int32', description: 'HTTP status of the response.' },
    error: {
      format: 'string',
      description: 'Reason for a missing value; empty after the next success.',
    },
  },
  mode: { frequency: { hertz: 10 } },
  createState: (): PollerState => ({ nowMs: 0, dueMs: 0, request: undefined, error: '' }),
  onCreated(state) {
    if (typeof (state.modules as { http?: Partial<HttpLibrary> }).http?.get !== 'function') {
      throw new Error(
        'This node does not have the library "http". Start it with --allow-fetch and the origins to read from.',
      );
    }
  },
  onProcessing(deltaTimeMs, inputs, state) {
    const read = {
      value(record: NumberRecord | undefined) {
        return record?.double ?? record?.float ?? record?.int32;
      },
      // A number that is not finite counts as missing.
      number(record: NumberRecord | undefined, fallback: number, min: number, max: number) {
        const value = this.value(record);
        return Number.isFinite(value) ? Math.min(max, Math.max(min, value!)) : fallback;
      },
      /** The value at the path in the response, or the reason why there is none. */
      answer(answer: PollerAnswer, path: string): { value: unknown } | { reason: string } {
        if ('reason' in answer) return answer;
        if (answer.status < 200 || answer.status > 299) {
          return { reason: `The service responded with status ${answer.status}.` };
        }
        let value: unknown;
        try {
          value = JSON.parse(answer.text);
        } catch {
          // Without a path, a response may be plain text.
          if (path === '') return { value: answer.text.trim() };
          return { reason: `The response is not JSON, so it has no "${path}".` };
        }
        // sensors[0].value and sensors.0.value are the same; a leading $ is the whole response.
        const keys = path.replace(/\[(\d+)\]/g, '.$1').split('.');
        for (const key of keys) {
          if (key === '' || key === '$') continue;
          if (typeof value !== 'object' || value === null || !Object.hasOwn(value, key)) {
            return { reason: `The response has no "${path}": "${key}" is missing.` };
          }
          value = (value as { [key: string]: unknown })[key];
        }
        return { value };
      },
    };
    const intervalMs = read.number(inputs.intervalMs, 1000, 100, 86_400_000);
    const timeoutMs = read.number(inputs.timeoutMs, 10_000, 100, 600_000);
    const url = inputs.url?.string.trim() ?? '';
    state.nowMs += deltaTimeMs;

    let result: ReturnType<typeof read.answer> | undefined;
    let status = 0;
    // Drop the pending request when the URL has changed.
    if (state.request !== undefined && state.request.url !== url) {
      state.request = undefined;
      state.dueMs = state.nowMs;
    }
    const request = state.request;
    if (request?.answer !== undefined) {
      state.request = undefined;
      if ('status' in request.answer) status = request.answer.status;
      result = read.answer(request.answer, inputs.path?.string.trim() ?? '');
    } else if (request !== undefined && state.nowMs - request.sinceMs >= timeoutMs) {
      // A late response is stored in the dropped request object, which is no longer read.
      state.request = undefined;
      result = { reason: `The service did not respond within ${timeoutMs} ms.` };
    }

    if (state.request === undefined && url !== '' && state.nowMs >= state.dueMs) {
      // Keep to the interval, unless requests are late.
      state.dueMs = Math.max(state.dueMs + intervalMs, state.nowMs + intervalMs / 2);
      if (/^https?:\/\//i.test(url)) {
        const next: NonNullable<PollerState['request']> = {
          url,
          sinceMs: state.nowMs,
          answer: undefined,
        };
        const asked = (state.modules as { http: HttpLibrary }).http.get(url);
        state.request = next;
        asked.then(
          (answer) => {
            next.answer = { status: answer.status, text: answer.text };
          },
          (error: unknown) => {
            const reason = (error as { message?: unknown } | null)?.message ?? error;
            next.answer = { reason: `The request failed: ${String(reason)}` };
          },
        );
      } else {
        result = {
          reason: `"${url}" is not a web address. It must start with http:// or https://.`,
        };
      }
    }
    if (result === undefined) return undefined;

    const error = 'reason' in result ? result.reason : '';
    const hasNewError = error !== state.error;
    state.error = error;
    const value = 'value' in result ? result.value : undefined;
    const isNumeric =
      typeof value === 'number' ||
      typeof value === 'boolean' ||
      (typeof value === 'string' && value.trim() !== '');
    const number = isNumeric ? Number(value) : NaN;
    return {
      outputs: {
        number: Number.isFinite(number) ? { double: number } : undefined,
        text:
          'value' in result
            ? { string: typeof value === 'string' ? value : JSON.stringify(value) }
            : undefined,
        status: status > 0 ? { int32: status } : undefined,
        error: hasNewError ? { string: error } : undefined,
      },
    };
  },
});
