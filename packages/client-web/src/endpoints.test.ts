import { describe, expect, it } from 'vitest';
import { resolveEndpoints } from './endpoints.ts';

describe('resolveEndpoints()', () => {
  it.each([
    [
      'http://localhost:8080',
      'http://localhost:8080/services/binary',
      'ws://localhost:8080/topicdata',
    ],
    [
      'http://localhost:8080/',
      'http://localhost:8080/services/binary',
      'ws://localhost:8080/topicdata',
    ],
    ['https://m.example', 'https://m.example/services/binary', 'wss://m.example/topicdata'],
    [
      'https://m.example/ubii',
      'https://m.example/ubii/services/binary',
      'wss://m.example/ubii/topicdata',
    ],
  ])('finds the services and the topic data of %s', (url, servicesUrl, topicDataUrl) => {
    expect(resolveEndpoints({ url }, undefined)).toEqual({ servicesUrl, topicDataUrl });
  });

  it('takes separate addresses as they are, those of an original master', () => {
    const options = {
      servicesUrl: 'http://m:8102/services/json',
      topicDataUrl: 'ws://m:8104/',
    };
    expect(resolveEndpoints(options, undefined)).toEqual(options);
  });

  it('takes what is missing from the page', () => {
    expect(resolveEndpoints({ topicDataUrl: 'http://m:8104/' }, 'http://page')).toEqual({
      servicesUrl: 'http://page/services/binary',
      topicDataUrl: 'ws://m:8104/',
    });
  });

  it.each([
    {},
    { servicesUrl: 'http://m/services' },
    { url: 'localhost' },
    { url: '' },
    { url: 'localhost:8080' },
    { url: 'ftp://m' },
  ])('refuses %o', (options) => {
    expect(() => resolveEndpoints(options, undefined)).toThrow(TypeError);
  });
});
