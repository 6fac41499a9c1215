import dns from 'node:dns';
import net from 'node:net';
import { afterAll, beforeAll, describe, expect, it } from 'vitest';
import { bodyPose } from '../src/body-pose/body-pose.ts';
import { handPose } from '../src/hand-pose/hand-pose.ts';
import { imageTools } from '../src/image-tools/image-tools.ts';
import { objectDetection } from '../src/object-detection/object-detection.ts';
import { driveWithVision, photoImage } from './vision-assets.ts';

/** Attempts to connect, through any of Node's APIs. */
const tried: string[] = [];
const { connect } = net.Socket.prototype;
const { lookup } = dns;
const { fetch } = globalThis;

beforeAll(() => {
  net.Socket.prototype.connect = function (this: net.Socket, ...options: unknown[]) {
    tried.push(`connect ${JSON.stringify(options[0])}`);
    return this;
  } as typeof connect;
  dns.lookup = ((name: string) => void tried.push(`lookup ${name}`)) as unknown as typeof lookup;
  globalThis.fetch = (input) => {
    tried.push(`fetch ${input instanceof Request ? input.url : String(input)}`);
    return Promise.reject(new TypeError('no network here'));
  };
});
afterAll(() => {
  net.Socket.prototype.connect = connect;
  dns.lookup = lookup;
  globalThis.fetch = fetch;
});

describe('vision modules in Node', () => {
  it.each([objectDetection, bodyPose, handPose, imageTools].map((one) => [one.name, one] as const))(
    '%s opens no connection, from its models to its results',
    async (_name, definition) => {
      const module = await driveWithVision(definition as never);
      const outputs = await module.run(1000, { image: photoImage('astronaut.jpg') }, ['image']);
      expect(Object.keys(outputs)).not.toHaveLength(0);
      expect(tried).toEqual([]);
    },
    120_000,
  );

  it('would be noticed if they did', async () => {
    await expect(fetchOf('http://elsewhere.example/')).rejects.toThrow();
    new net.Socket().connect(80, 'elsewhere.example');
    expect(tried.splice(0)).toEqual(['fetch http://elsewhere.example/', 'connect 80']);
  });
});

const fetchOf = (url: string): Promise<Response> => globalThis.fetch(url);
