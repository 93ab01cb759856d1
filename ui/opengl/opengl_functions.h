// SPDX-FileCopyrightText: 2026 The Planewright authors
// SPDX-License-Identifier: BSD-3-Clause

// The OpenGL functions that VTK's libraries call by name: PASS(result, name, parameters, arguments). No include guard:
// whoever includes this defines PASS first.
PASS(void, glBindTexture, (GLenum target, GLuint texture), (target, texture))
PASS(void, glClear, (GLbitfield mask), (mask))
PASS(void, glClearColor, (GLclampf red, GLclampf green, GLclampf blue, GLclampf alpha), (red, green, blue, alpha))
PASS(void, glClearDepth, (GLclampd depth), (depth))
PASS(void, glClearStencil, (GLint value), (value))
PASS(void, glColorMask, (GLboolean red, GLboolean green, GLboolean blue, GLboolean alpha), (red, green, blue, alpha))
PASS(void, glCopyTexImage2D,
     (GLenum target, GLint level, GLenum format, GLint x, GLint y, GLsizei width, GLsizei height, GLint border),
     (target, level, format, x, y, width, height, border))
PASS(void, glCullFace, (GLenum mode), (mode))
PASS(void, glDeleteTextures, (GLsizei count, const GLuint* textures), (count, textures))
PASS(void, glDepthFunc, (GLenum function), (function))
PASS(void, glDepthMask, (GLboolean flag), (flag))
PASS(void, glDisable, (GLenum what), (what))
PASS(void, glDrawArrays, (GLenum mode, GLint first, GLsizei count), (mode, first, count))
PASS(void, glDrawElements, (GLenum mode, GLsizei count, GLenum type, const GLvoid* indices),
     (mode, count, type, indices))
PASS(void, glEnable, (GLenum what), (what))
PASS(void, glFinish, (), ())
PASS(void, glFlush, (), ())
PASS(void, glGenTextures, (GLsizei count, GLuint* textures), (count, textures))
PASS(void, glGetBooleanv, (GLenum what, GLboolean* values), (what, values))
PASS(void, glGetDoublev, (GLenum what, GLdouble* values), (what, values))
PASS(GLenum, glGetError, (), ())
PASS(void, glGetFloatv, (GLenum what, GLfloat* values), (what, values))
PASS(void, glGetIntegerv, (GLenum what, GLint* values), (what, values))
PASS(const GLubyte*, glGetString, (GLenum what), (what))
PASS(void, glGetTexImage, (GLenum target, GLint level, GLenum format, GLenum type, GLvoid* pixels),
     (target, level, format, type, pixels))
PASS(void, glGetTexLevelParameteriv, (GLenum target, GLint level, GLenum what, GLint* values),
     (target, level, what, values))
PASS(GLboolean, glIsEnabled, (GLenum what), (what))
PASS(void, glLineWidth, (GLfloat width), (width))
PASS(void, glPixelStorei, (GLenum what, GLint value), (what, value))
PASS(void, glPointSize, (GLfloat size), (size))
PASS(void, glReadBuffer, (GLenum mode), (mode))
PASS(void, glReadPixels, (GLint x, GLint y, GLsizei width, GLsizei height, GLenum format, GLenum type, GLvoid* pixels),
     (x, y, width, height, format, type, pixels))
PASS(void, glScissor, (GLint x, GLint y, GLsizei width, GLsizei height), (x, y, width, height))
PASS(void, glTexEnvi, (GLenum target, GLenum what, GLint value), (target, what, value))
PASS(void, glTexImage1D,
     (GLenum target, GLint level, GLint inner, GLsizei width, GLint border, GLenum format, GLenum type,
      const GLvoid* pixels),
     (target, level, inner, width, border, format, type, pixels))
PASS(void, glTexImage2D,
     (GLenum target, GLint level, GLint inner, GLsizei width, GLsizei height, GLint border, GLenum format, GLenum type,
      const GLvoid* pixels),
     (target, level, inner, width, height, border, format, type, pixels))
PASS(void, glTexParameterf, (GLenum target, GLenum what, GLfloat value), (target, what, value))
PASS(void, glTexParameterfv, (GLenum target, GLenum what, const GLfloat* values), (target, what, values))
PASS(void, glTexParameteri, (GLenum target, GLenum what, GLint value), (target, what, value))
PASS(void, glViewport, (GLint x, GLint y, GLsizei width, GLsizei height), (x, y, width, height))
