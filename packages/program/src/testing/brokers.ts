export * from './broker-program.ts';
export * from './cuttable-port.ts';
export * from './free-port.ts';
export * from './start-nats.ts';
