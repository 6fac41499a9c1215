export * from './cuttable-port.ts';
export * from './start-nats.ts';
