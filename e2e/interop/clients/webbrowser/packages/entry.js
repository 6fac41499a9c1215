// The package is written for bundlers only: it mixes module styles and leaves out file endings.
export { UbiiClientService } from '@tum-far/ubii-node-webbrowser/src/index.js';
export { ProtobufTranslator, MSG_TYPES } from '@tum-far/ubii-msg-formats';
